// The nozzle's orientation by rule (Castelli 2020, 4.6.2), alone and through a whole motion.
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "motion/external_axes.h"
#include "motion/motion.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/tool_frames.h"
#include "process/tooling.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::NozzleRotation;
using robot::JointVector;

namespace {

robot::Cell cellOf(const char* id) {
  platform::PlatformSolid plate;
  plate.polygon = test::disc(20.0);
  return robot::loadCell(id, process::loadProcess("fdm-1.0"), plate);
}

plan::ToolPlan wavy() {
  plan::ToolPlan plan;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> lean(-0.8, 0.8), step(0.3, 2.0);
  std::vector<Vector3d> points, directions;
  Vector3d p(0, 0, 20);
  for (int i = 0; i < 60; ++i) {
    p += Vector3d(step(random), lean(random), 0.2 * lean(random));
    points.push_back(p);
    directions.push_back(Vector3d(lean(random), lean(random), 1.0).normalized());
  }
  test::appendPath(plan, points, directions, 0);
  return plan;
}

std::vector<Quaterniond> frames(NozzleRotation rule, const plan::ToolPlan& plan,
                                const robot::Cell& cell,
                                const std::vector<JointVector>& axes = {}) {
  return motion::toolFrames(rule, plan, cell, 0, plan.waypointCount(), axes, motion::uprightTool(),
                            JointVector::Zero(axes.empty() ? 0 : 2));
}

} // namespace

TEST(ToolFrames, EachRuleHasItsOwnX) {
  const plan::ToolPlan plan = wavy();
  const robot::Cell cell = cellOf("irb1200-moving");
  const auto tangent = frames(NozzleRotation::Tangent, plan, cell),
             axis = frames(NozzleRotation::WorkAxis, plan, cell),
             rodrigues = frames(NozzleRotation::Rodrigues, plan, cell),
             free = frames(NozzleRotation::Free, plan, cell);
  ASSERT_EQ(tangent.size(), plan.waypointCount());
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    const Vector3d& d = plan.direction[i];
    for (const Quaterniond& q : {tangent[i], axis[i], rodrigues[i], free[i]})
      EXPECT_LT((q * Vector3d::UnitZ() + d).norm(), 1e-12);
    // The tangent is in the plane of x and z, ahead.
    const Vector3d t = (plan.position[std::min(i + 1, plan.waypointCount() - 1)] -
                        plan.position[i > 0 ? i - 1 : 0])
                           .normalized();
    EXPECT_NEAR(t.dot(tangent[i] * Vector3d::UnitY()), 0.0, 1e-12);
    EXPECT_GT(t.dot(tangent[i] * Vector3d::UnitX()), 0.0);
    EXPECT_NEAR((axis[i] * Vector3d::UnitY()).x(), 0.0, 1e-12);
    EXPECT_GT((axis[i] * Vector3d::UnitX()).x(), 0.0);
    // Castelli 4.1: R = I + K + K^2 / (1 + cos), K of upright x direction.
    const Vector3d k = Vector3d::UnitZ().cross(d);
    Eigen::Matrix3d cross;
    cross << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
    const Eigen::Matrix3d rotation =
        Eigen::Matrix3d::Identity() + cross + cross * cross / (1.0 + d.z());
    const Eigen::Matrix3d upright = Vector3d(1, -1, -1).asDiagonal();
    EXPECT_LT((rodrigues[i].toRotationMatrix() - rotation * upright).norm(), 1e-12);
  }
}

// A tangent that has no way across the direction, and a standstill: the frame before is carried.
TEST(ToolFrames, FrameIsCarriedOverWhereTheRuleIsUndefined) {
  plan::ToolPlan plan;
  const Vector3d up = Vector3d::UnitZ();
  test::appendPath(plan, {{0, 0, 1}, {0, 1, 1}, {0, 1, 2}, {0, 1, 3}, {0, 1, 3}, {0, 1, 3}},
                   std::vector<Vector3d>(6, up), 0);
  const auto tools = frames(NozzleRotation::Tangent, plan, cellOf("irb1200-moving"));
  for (const Quaterniond& q : tools)
    EXPECT_LT((q * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-12);
}

// On a plate that tilts and turns x keeps to where the work frame's x is with the axes at 0.
TEST(ToolFrames, ExternalAxesTurnUnderTheRule) {
  const plan::ToolPlan plan = wavy();
  const robot::Cell cell = cellOf("irb1200-irbp");
  std::vector<JointVector> axes;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    axes.emplace_back(JointVector::Zero(2));
    axes.back() << 0.01 * static_cast<double>(i), 0.05 * static_cast<double>(i);
  }
  const auto tools = frames(NozzleRotation::WorkAxis, plan, cell, axes);
  const Vector3d along = motion::axesRotation(cell, JointVector::Zero(2)) * Vector3d::UnitX();
  for (std::size_t i = 0; i < tools.size(); ++i) {
    EXPECT_LT((tools[i] * Vector3d::UnitZ() + plan.direction[i]).norm(), 1e-12);
    const Quaterniond seen = motion::axesRotation(cell, axes[i]) * tools[i];
    EXPECT_NEAR(along.dot(seen * Vector3d::UnitY()), 0.0, 1e-12);
  }
}

TEST(ToolFrames, AMotionKeepsToItsRule) {
  const plan::ToolPlan plan = test::slab(12.0, 2);
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = cellOf("irb1200-moving");
  const collision::GrowingPart part(plan, 1.0, {});
  motion::MotionOptions options;
  options.rotation = NozzleRotation::WorkAxis;
  const motion::MotionResult moved =
      motion::MotionPlanner(plan, cell, process::Tooling(process), part, options).plan({});
  EXPECT_TRUE(moved.skipped.empty());
  const plan::Trajectory& t = moved.trajectory;
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print) {
      const JointVector q = Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
      EXPECT_LT((cell.work_T_tool(q).linear().col(0) - Vector3d::UnitX()).norm(), 1e-9);
    }
}
