// The least clearance along joint motions, against dense sampling.
#include "collision/growing_part.h"
#include "collision/way_clearance.h"
#include "plan/tool_plan.h"
#include "robot/cell.h"

#include "base/run_context.h"
#include "process/process.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

plan::ToolPlan tower() {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 20; ++layer) {
    const std::size_t first = plan.waypointCount();
    for (int k = 0; k <= 12; ++k) {
      const double a = 2.0 * M_PI * k / 12;
      plan.position.emplace_back(15.0 * std::cos(a), 15.0 * std::sin(a), 0.8 * (layer + 1));
      plan.direction.push_back(Vector3d::UnitZ());
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20.0f);
    }
    plan.paths.push_back({.first = first, .count = 13});
  }
  return plan;
}

constexpr double kCap = 200.0;
constexpr int kSamples = 300;

// A cell with the tower on its plate, and the closest pairs in it.
struct Scene {
  explicit Scene(const char* id)
      : process(process::loadProcess("fdm-1.0")),
        cell(robot::loadCell(id, process, {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}})),
        collision(cell, process), plan(tower()), part(plan, 0.45, {}), ways(collision, part),
        before(plan.waypointCount()) {}

  double clearanceAt(const JointVector& q) const {
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    return collision.clearanceToPart(frames, part, before, collision.clearance(frames, kCap));
  }
  double sampledMinimum(const JointVector& from, const JointVector& to) const {
    double minimum = std::min(clearanceAt(from), clearanceAt(to));
    for (int k = 1; k < kSamples; ++k)
      minimum =
          std::min(minimum, clearanceAt(from + static_cast<double>(k) / kSamples * (to - from)));
    return minimum;
  }
  // How the clearance grows with each joint of the arm.
  JointVector growthAt(const JointVector& q) const {
    constexpr double kStep = 1e-4;
    JointVector growth = JointVector::Zero(q.size());
    for (Eigen::Index j = 0; j < cell.armDof(); ++j) {
      JointVector less = q, more = q;
      less[j] -= kStep;
      more[j] += kStep;
      growth[j] = (clearanceAt(more) - clearanceAt(less)) / (2.0 * kStep);
    }
    return growth;
  }

  const process::Process process;
  const robot::Cell cell;
  const collision::CellCollision collision;
  const plan::ToolPlan plan;
  const collision::GrowingPart part;
  const collision::MotionClearance ways;
  const std::size_t before;
};

class WayClearances : public testing::TestWithParam<const char*> {
protected:
  JointVector random(double reach) {
    JointVector q = JointVector::Zero(scene_.cell.home().size());
    for (Eigen::Index j = 0; j < scene_.cell.armDof(); ++j)
      q[j] = reach * share_(engine_);
    return q;
  }
  void expectKept(const JointVector& from, const JointVector& to, double reach) {
    const double ends = std::min(scene_.clearanceAt(from), scene_.clearanceAt(to));
    const double minimum = scene_.sampledMinimum(from, to);
    if (minimum <= 0.5)
      return; // contact: there is no clearance to compare
    ++reported_;
    between_ += minimum < ends - 0.1;
    const double reported = scene_.ways.along(from, to, scene_.before, ends);
    EXPECT_LE(reported, minimum + 1e-6) << GetParam() << " " << reported_;
    // Samples are no closer to the truth than the distance moved between them.
    EXPECT_GE(reported, minimum - collision::kMotionExactMm - 0.5 * reach)
        << GetParam() << " " << reported_;
  }

  const Scene scene_{GetParam()};
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> share_{-1.0, 1.0};
  int reported_ = 0, between_ = 0; // motions, and those whose least distance is at neither end
};

} // namespace

// The returned clearance holds all along the way, and underestimates by no more than its tolerance.
TEST_P(WayClearances, NothingComesCloserOnTheWay) {
  for (int n = 0; n < 60; ++n) {
    const double reach = n % 3 == 0 ? 0.3 : n % 3 == 1 ? 1.5 : 3.0; // rad
    const JointVector from = scene_.cell.home() + random(0.5);
    expectKept(from, from + random(reach), reach);
  }
  EXPECT_GT(reported_, 10);
}

// Motions that pass by something: in their middle the clearance neither grows nor falls, and at
// both ends it is greater.
TEST_P(WayClearances, NothingComesCloserWhereSomethingIsPassed) {
  constexpr int kMotions = 20, kAttempts = 20000;
  for (int n = 0; n < kAttempts && reported_ < kMotions; ++n) {
    const double reach = n % 2 == 0 ? 0.2 : 0.6; // rad
    const JointVector middle = scene_.cell.home() + random(0.7);
    const JointVector growth = scene_.growthAt(middle);
    JointVector step = random(reach);
    if (growth.norm() < 1.0)
      continue; // the closest pair does not move
    step -= growth.dot(step) / growth.squaredNorm() * growth;
    const JointVector from = middle - step, to = middle + step;
    if (std::min(scene_.clearanceAt(from), scene_.clearanceAt(to)) >
        scene_.clearanceAt(middle) + 0.2)
      expectKept(from, to, 2.0 * reach);
  }
  EXPECT_EQ(reported_, kMotions);
  EXPECT_EQ(between_, reported_);
}

INSTANTIATE_TEST_SUITE_P(Cells, WayClearances,
                         testing::Values("ur5-fixed", "ur5-moving", "irb2400-moving"));
