// A transfer across a tall printed part: round it or over it, clear all the way.
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kBeside = 45.0;

void line(plan::ToolPlan& plan, double y, double z, int layer) {
  std::vector<Vector3d> points;
  for (int x = -20; x <= 20; x += 2)
    points.emplace_back(x, y, z);
  test::appendPath(plan, points, std::vector<Vector3d>(points.size(), Vector3d::UnitZ()), layer);
}

// A wall, then a line at its foot on one side, and one on the other.
plan::ToolPlan wall(double height) {
  plan::ToolPlan plan;
  int layer = 0;
  for (double z = 0.8; z < height; z += 0.8)
    line(plan, 0.0, z, layer++);
  line(plan, kBeside, 0.8, layer);
  line(plan, -kBeside, 0.8, layer);
  return plan;
}

} // namespace

TEST(TallPart, IsCrossedClear) {
  const process::Process process = process::loadProcess("fdm-1.0");
  for (const char* id : {"ur5-fixed", "irb1200-moving", "kr10-r1100-moving"}) {
    constexpr double kHeight = 80.0;
    const plan::ToolPlan plan = wall(kHeight);
    platform::PlatformSolid plate;
    plate.polygon = test::disc(60.0);
    const robot::Cell cell = robot::loadCell(id, process, plate);
    const collision::CellCollision collision(cell, process);
    const collision::GrowingPart part(plan, 1.0, {});
    const motion::MotionResult moved =
        motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({});
    EXPECT_TRUE(moved.skipped.empty()) << id;
    const plan::Trajectory& t = moved.trajectory;
    // From the last line but one to the last: everything else is printed by then.
    const std::size_t to = plan.paths.back().first, from = to - 1;
    const auto at = [&](std::size_t waypoint) {
      return static_cast<std::size_t>(std::ranges::find(t.waypoint, waypoint) - t.waypoint.begin());
    };
    ASSERT_LT(at(to), t.pointCount()) << id;
    double highest = 0.0, farthest = 0.0;
    for (std::size_t i = at(from) + 1; i <= at(to); ++i) {
      const Eigen::Map<const Eigen::VectorXd> a(t.at(i - 1), t.dof), b(t.at(i), t.dof);
      const int pieces = std::max(1, static_cast<int>((b - a).cwiseAbs().maxCoeff() / 0.003));
      for (int k = 0; k < pieces; ++k) {
        const JointVector q = a + (k + 0.37) / pieces * (b - a);
        collision::CellCollision::Frames frames;
        cell.framePoses(q, frames);
        ASSERT_FALSE(collision.bodies(frames, {0.0, 0.0, -0.1})) << id << ' ' << i;
        ASSERT_FALSE(collision.bodiesAndPart(frames, part, to, {0.0, 0.0, 0.0})) << id << ' ' << i;
        ASSERT_FALSE(collision.headTouchesPart(cell.work_T_tool(q), part, to, -0.1))
            << id << ' ' << i;
        const Vector3d tip = cell.work_T_tool(q).translation();
        highest = std::max(highest, tip.z());
        farthest = std::max(farthest, std::abs(tip.x()));
      }
    }
    EXPECT_TRUE(highest > kHeight || farthest > 20.0) << id; // not through it
  }
}
