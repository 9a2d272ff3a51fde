// Waits until the beads below have cooled: closed forms for rings, and a check by brute force on
// random stacks of beads.
#include "motion/waits.h"

#include "base/units.h"
#include "motion/sample_plans.h"
#include "plan/waypoints.h"
#include "process/process.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace voluta::motion {
namespace {

constexpr double kHeight = 0.8, kWidth = 1.2, kTravelS = 1.5;

robot::Cell cell() {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return robot::loadCell("ur5-fixed", process::loadProcess("fdm-1.0"), test::disc(20.0));
}

struct Stack {
  plan::ToolPlan plan;
  plan::Trajectory trajectory;

  void add(const std::vector<Eigen::Vector3d>& points, double speed, int layer, double travelS) {
    plan::ToolPath path;
    path.first = plan.waypointCount();
    path.count = points.size();
    path.layer = layer;
    plan::Trajectory& t = trajectory;
    const auto point = [&](plan::MoveKind move, std::size_t waypoint, double seconds) {
      t.joints.insert(t.joints.end(), home.data(), home.data() + home.size());
      t.timeS.push_back(t.timeS.empty() ? 0.0 : t.timeS.back() + seconds);
      t.move.push_back(move);
      t.waypoint.push_back(waypoint);
      t.extrudedMm3.push_back(0.0);
    };
    t.dof = static_cast<int>(home.size());
    if (t.timeS.empty())
      point(plan::MoveKind::Joint, plan::kNoWaypoint, 0.0);
    else
      point(plan::MoveKind::Linear, plan::kNoWaypoint, 0.5 * travelS);
    point(plan::MoveKind::Linear, path.first, 0.5 * travelS);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k > 0)
        point(plan::MoveKind::Print, path.first + k, (points[k] - points[k - 1]).norm() / speed);
      plan.position.push_back(points[k]);
      plan.direction.push_back(Eigen::Vector3d::UnitZ());
      plan.widthMm.push_back(static_cast<float>(kWidth));
      plan.heightMm.push_back(static_cast<float>(kHeight));
      plan.speedMmPerS.push_back(static_cast<float>(speed));
    }
    plan.paths.push_back(path);
  }
  double waitS(const std::vector<plan::TrajectoryEvent>& waits) const {
    return std::accumulate(waits.begin(), waits.end(), 0.0,
                           [](double sum, const auto& wait) { return sum + wait.seconds; });
  }

  Eigen::VectorXd home = cell().home();
};

std::vector<Eigen::Vector3d> ring(double x, double radius, int layer, int points = 120) {
  std::vector<Eigen::Vector3d> ring;
  for (int k = 0; k <= points; ++k) {
    const double angle = 2.0 * base::kPi * (k % points) / points;
    ring.emplace_back(x + radius * std::cos(angle), radius * std::sin(angle),
                      (layer + 1) * kHeight);
  }
  return ring;
}
double length(const std::vector<Eigen::Vector3d>& points) {
  double sum = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    sum += (points[k] - points[k - 1]).norm();
  return sum;
}

// 12 layers of 40 s that have to cool for 60 s: each of the 11 travels lacks 20 s less its own
// time.
TEST(Waits, ARingInClosedForm) {
  Stack stack;
  const double speed = length(ring(0.0, 20.0, 0)) / 40.0;
  for (int layer = 0; layer < 12; ++layer)
    stack.add(ring(0.0, 20.0, layer), speed, layer, kTravelS);
  const auto waits = waitsToCool(stack.plan, stack.trajectory, cell(), 60.0);
  ASSERT_EQ(waits.size(), 11u);
  const double bound = 11.0 * (20.0 - kTravelS);
  EXPECT_GE(stack.waitS(waits), bound);
  EXPECT_LE(stack.waitS(waits), 1.05 * bound);
  for (const plan::TrajectoryEvent& wait : waits) {
    EXPECT_EQ(wait.kind, plan::EventKind::Wait);
    EXPECT_NE(stack.trajectory.move[wait.point], plan::MoveKind::Print) << "on the travel";
    EXPECT_NE(stack.trajectory.move[wait.point - 1], plan::MoveKind::Print) << "behind the lift";
  }
}

// Two islands of 35 s in turn: each cools for the time of both and two travels.
TEST(Waits, TwoIslandsNeedNone) {
  Stack stack;
  const double speed = length(ring(0.0, 20.0, 0)) / 35.0;
  for (int layer = 0; layer < 12; ++layer)
    for (const double x : {0.0, 60.0})
      stack.add(ring(x, 20.0, layer), speed, layer, kTravelS);
  EXPECT_TRUE(waitsToCool(stack.plan, stack.trajectory, cell(), 60.0).empty());
}

// The island that was printed last comes first in the next layer: it lacks all but the travel.
TEST(Waits, IslandsInTurnedOrderWaitForTheLastOne) {
  Stack stack;
  const double speed = length(ring(0.0, 20.0, 0)) / 35.0;
  for (int layer = 0; layer < 12; ++layer)
    for (const double x : {0.0, 60.0})
      stack.add(ring(layer % 2 ? 60.0 - x : x, 20.0, layer), speed, layer, kTravelS);
  const auto waits = waitsToCool(stack.plan, stack.trajectory, cell(), 60.0);
  const double bound = 11.0 * (60.0 - 35.0 - kTravelS);
  EXPECT_GE(stack.waitS(waits), bound);
  EXPECT_LE(stack.waitS(waits), 1.05 * bound);
}

// Printed back and forth, the end of the wall below is the beginning of the next one.
TEST(Waits, AWallBackAndForthWaitsForItsEnd) {
  Stack stack;
  std::vector<Eigen::Vector3d> wall;
  for (int k = 0; k <= 40; ++k)
    wall.emplace_back(k, 0.0, kHeight);
  stack.add(wall, 2.0, 0, kTravelS);
  std::ranges::reverse(wall);
  for (Eigen::Vector3d& p : wall)
    p.z() += kHeight;
  stack.add(wall, 2.0, 1, kTravelS);
  const auto waits = waitsToCool(stack.plan, stack.trajectory, cell(), 30.0);
  ASSERT_EQ(waits.size(), 1u);
  EXPECT_NEAR(waits[0].seconds, 30.0 - kTravelS, 1e-3);
}

TEST(Waits, BeadsBesideEachOtherNeedNone) {
  Stack stack;
  for (int k = 0; k < 8; ++k)
    stack.add({{0.0, kWidth * k, kHeight}, {30.0, kWidth * k, kHeight}}, 10.0, 0, 0.1);
  EXPECT_TRUE(waitsToCool(stack.plan, stack.trajectory, cell(), 500.0).empty());
}

// Lines of random directions, speeds and order, layer upon layer: with the waits every place is
// old enough, and no wait can be shorter by a tenth of a second.
TEST(Waits, RandomStacksAreHeldAndNotLonger) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const robot::Cell ur5 = cell();
  std::size_t waited = 0;
  for (int seed = 0; seed < 100; ++seed) {
    Stack stack;
    for (int layer = 0; layer < 4; ++layer)
      for (int line = 0; line < 4; ++line) {
        const double angle = uniform(0.0, base::kPi);
        const Eigen::Vector3d middle(uniform(-6.0, 6.0), uniform(-6.0, 6.0), (layer + 1) * kHeight),
            half(8.0 * std::cos(angle), 8.0 * std::sin(angle), 0.0);
        stack.add({middle - half, middle, middle + half}, uniform(2.0, 20.0), layer,
                  uniform(0.2, 3.0));
      }
    const double minimum = uniform(5.0, 40.0);
    plan::Trajectory& t = stack.trajectory;
    t.events = waitsToCool(stack.plan, t, ur5, minimum);
    waited += t.events.size();
    const auto shortest = [&] {
      float time = 1e9F;
      for (const float s : layerTimesOf(stack.plan, t))
        time = s < 0.0F ? time : std::min(time, s);
      return static_cast<double>(time);
    };
    EXPECT_GE(shortest(), minimum - 1e-3);
    for (plan::TrajectoryEvent& wait : t.events) {
      if (wait.seconds < 0.1)
        continue;
      wait.seconds -= 0.1;
      EXPECT_LT(shortest(), minimum - 0.05);
      wait.seconds += 0.1;
    }
  }
  EXPECT_GT(waited, 200u);
}

} // namespace
} // namespace voluta::motion
