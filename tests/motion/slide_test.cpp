// A plate on a linear slide: the cell "kr10-r1100-slide".
#include "base/run_context.h"
#include "motion/external_axes.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr Eigen::Index kSlide = 6;

struct Printed {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell = robot::loadCell("kr10-r1100-slide", process, plate());
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Printed(plan::ToolPlan p)
      : plan(std::move(p)), part(plan, 4.0, {}),
        result(motion::MotionPlanner(plan, cell, process, part, {}).plan({})) {}

  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = {{-100, -1100}, {100, -1100}, {100, 1100}, {-100, 1100}};
    return solid;
  }
  JointVector q(std::size_t i) const {
    const plan::Trajectory& t = result.trajectory;
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
};

// Along the slide, from -half to half, there and back.
plan::ToolPlan lines(double half) {
  plan::ToolPlan plan;
  for (int l = 0; l < 2; ++l) {
    std::vector<Vector3d> points;
    const int steps = static_cast<int>(half);
    for (int i = -steps; i <= steps; ++i)
      points.emplace_back(0.0, l == 0 ? i : -i, 0.8 * (l + 1));
    test::appendPath(plan, points, std::vector<Vector3d>(points.size(), Vector3d::UnitZ()), l);
  }
  return plan;
}

} // namespace

// Longer than the arm reaches: the plate slides along under it.
TEST(Slide, BringsTheEndsOfALongPart) {
  const Printed p(lines(1050.0));
  EXPECT_TRUE(p.result.skipped.empty()) << p.result.skipped.size();
  const plan::Trajectory& t = p.result.trajectory;
  ASSERT_EQ(t.dof, 7);
  double low = 0.0, high = 0.0;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const JointVector q = p.q(i);
    low = std::min(low, q[kSlide]);
    high = std::max(high, q[kSlide]);
    for (Eigen::Index j = 0; j < 7; ++j) {
      EXPECT_GE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].min);
      EXPECT_LE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].max);
    }
    if (t.waypoint[i] != plan::kNoWaypoint) {
      const Isometry3d pose = p.cell.work_T_tool(q);
      EXPECT_LT((pose.translation() - p.plan.position[t.waypoint[i]]).norm(), 1e-8);
    }
    if (i == 0)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    for (Eigen::Index j = 0; j < 7; ++j)
      EXPECT_LE(std::abs(q[j] - p.q(i - 1)[j]),
                dt * p.cell.limits()[static_cast<std::size_t>(j)].velocity + 1e-9);
  }
  EXPECT_LT(low, -200.0);
  EXPECT_GT(high, 200.0);
  EXPECT_LT((p.q(t.pointCount() - 1) - p.cell.home()).norm(), 1e-12);
}

TEST(Slide, StaysWhereTheArmGetsByItself) {
  const Printed p(lines(50.0));
  EXPECT_TRUE(p.result.skipped.empty());
  for (std::size_t i = 0; i < p.result.trajectory.pointCount(); ++i)
    EXPECT_EQ(p.q(i)[kSlide], 0.0);
}
