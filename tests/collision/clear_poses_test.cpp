// Poses that brute force calls clear are called clear, and poses in which it finds bodies to meet
// are found, over cells of every kind: points all over every solid, each held against all solids of
// the other body and all that is printed.
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "collision/random_shapes.h"
#include "collision/shape_distance.h"
#include "helpers/all_seeds.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kStepMm = 12.0;
// No point of a solid is further than this from a point of the lattice.
const double kCoverMm = 0.5 * std::sqrt(3.0) * kStepMm;
constexpr double kPolyhedraMm = 1.5; // the most by which round solids grow as polyhedra
constexpr double kBeadMm = 1.5;      // from a waypoint to the far corner of its bead's cells

// Points no further than kCoverMm from a body's surface such that every point of its surface has
// one of them within kCoverMm. In the body's frame.
std::vector<Vector3d> lattice(const robot::Body& body) {
  std::vector<Vector3d> points;
  for (const robot::Shape& shape : body.shapes) {
    const collision::Ball ball =
        collision::boundingBall(collision::place(shape, Isometry3d::Identity()));
    const int n = static_cast<int>(std::ceil((ball.radius + kCoverMm) / kStepMm));
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        for (int k = -n; k <= n; ++k) {
          const Vector3d p = ball.centre + kStepMm * Vector3d(i, j, k);
          if (std::abs(collision::signedDistance(shape, p)) <= kCoverMm)
            points.push_back(p);
        }
  }
  return points;
}

// A heap of beads on the plate, none of them near its middle's stem.
plan::ToolPlan heap() {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 20; ++layer)
    for (int i = 0; i <= 40; ++i) {
      plan.position.emplace_back(i - 20.0, layer % 2 ? 4.0 : -4.0, 0.8 * (layer + 1));
      plan.direction.emplace_back(0, 0, 1);
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20);
    }
  for (int layer = 0; layer < 20; ++layer)
    plan.paths.push_back({.first = static_cast<std::size_t>(41 * layer), .count = 41});
  return plan;
}

class ClearPoses : public testing::TestWithParam<const char*> {
protected:
  ClearPoses()
      : process(process::loadProcess("fdm-1.0")),
        cell(robot::loadCell(
            GetParam(), process,
            std::vector<Eigen::Vector2d>{{-40, -40}, {40, -40}, {40, 40}, {-40, 40}})),
        collision(cell, process) {
    for (const robot::Body& body : cell.bodies())
      points.push_back(lattice(body));
  }

  robot::JointVector randomJoints(test::RandomShapes& random) const {
    robot::JointVector q(cell.dof());
    for (int i = 0; i < cell.dof(); ++i) {
      const auto& limit = cell.limits()[static_cast<std::size_t>(i)];
      q[i] = random.number(std::max(limit.min, -3.1e3), std::min(limit.max, 3.1e3));
    }
    return q;
  }

  // Least of the points of one body to the solids of the other: no less than the distance of the
  // bodies, and no more than kCoverMm more than it.
  double pointsTo(int a, int b, const collision::CellCollision::Frames& frames) const {
    const robot::Body &from = cell.bodies()[static_cast<std::size_t>(a)],
                      &to = cell.bodies()[static_cast<std::size_t>(b)];
    const Isometry3d to_T_from = frames[static_cast<std::size_t>(to.frame)].inverse() *
                                 frames[static_cast<std::size_t>(from.frame)];
    double minimum = 1e9;
    for (const Vector3d& p : points[static_cast<std::size_t>(a)]) {
      const Vector3d q = to_T_from * p;
      for (const robot::Shape& shape : to.shapes)
        minimum = std::min(minimum, collision::signedDistance(shape, q));
    }
    return minimum;
  }

  const process::Process process;
  const robot::Cell cell;
  const collision::CellCollision collision;
  std::vector<std::vector<Vector3d>> points; // per body
};

} // namespace

TEST_P(ClearPoses, AreCalledClearAndTheOthersFound) {
  const int wanted = test::ofSeeds(50, 200); // of each of five cells
  const plan::ToolPlan plan = heap();
  const collision::GrowingPart part(plan, 0.4, base::RunContext());
  const std::size_t all = plan.position.size();
  const collision::Margins margins;
  test::RandomShapes random(1123);
  int clear = 0, met = 0, near = 0;
  for (int tries = 0; (clear < wanted || met == 0) && tries < 20000; ++tries) {
    const robot::JointVector q = randomJoints(random);
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    double bodies = 1e9;
    for (const auto& [a, b] : cell.checkedPairs()) {
      const bool tip = cell.bodies()[static_cast<std::size_t>(a)].role == robot::BodyRole::Head &&
                       cell.bodies()[static_cast<std::size_t>(b)].role == robot::BodyRole::Platform;
      if (!tip && bodies > 0.0)
        bodies = std::min(bodies, pointsTo(a, b, frames));
    }
    const Isometry3d base_T_work = frames[static_cast<std::size_t>(cell.workFrame())];
    double printed = 1e9;
    for (const int b : cell.bodiesAgainstPart()) {
      const robot::Body& body = cell.bodies()[static_cast<std::size_t>(b)];
      if (body.role == robot::BodyRole::Head)
        continue;
      const Isometry3d body_T_work =
          frames[static_cast<std::size_t>(body.frame)].inverse() * base_T_work;
      for (const Vector3d& p : plan.position)
        for (const robot::Shape& shape : body.shapes)
          printed = std::min(printed, collision::signedDistance(shape, body_T_work * p));
    }
    const auto contact = collision.bodies(frames, margins);
    const auto withPart = collision.bodiesAndPart(frames, part, all, margins);
    if (bodies - kCoverMm - kPolyhedraMm > margins.bodiesMm && printed - kBeadMm > margins.partMm) {
      ++clear;
      EXPECT_FALSE(contact.has_value())
          << base::english(collision.nameOf(contact->first)) << " and "
          << base::english(collision.nameOf(contact->second)) << ", " << bodies << " mm apart";
      EXPECT_FALSE(withPart.has_value())
          << base::english(collision.nameOf(withPart->first)) << ", " << printed << " mm off";
      near += bodies < 60.0 || printed < 60.0;
    }
    // A lattice point may be that far outside its own solid.
    if (bodies <= -kCoverMm) {
      ++met;
      EXPECT_TRUE(contact.has_value());
    }
    if (printed <= 0.0) {
      ++met;
      EXPECT_TRUE(withPart.has_value());
    }
  }
  EXPECT_GE(clear, wanted);
  EXPECT_GT(met, 0);
  EXPECT_GT(near, wanted / 10) << "clear poses of which nothing is near prove little";
}

INSTANTIATE_TEST_SUITE_P(Cells, ClearPoses,
                         testing::Values("ur5-fixed", "irb1200-irbp", "t3", "kr10-r1100-track",
                                         "rv2f-moving"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::erase(name, '-');
                           return name;
                         });
