#include "replay/executed_path.h"

#include "base/run_context.h"
#include "base/units.h"
#include "replay/replay_scene.h"

#include <gtest/gtest.h>
#include <set>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

plan::ReadProgram points(const std::vector<Vector3d>& tips, double speed, double blend = 0.0) {
  plan::ReadProgram program;
  for (const Vector3d& p : tips) {
    plan::ProgramMotion m;
    m.target = plan::TargetKind::ToolPoint;
    m.position = p;
    m.speedMmPerS = speed;
    m.blendMm = blend;
    m.extruding = true;
    program.motions.push_back(m);
  }
  return program;
}

TEST(ExecutedPath, SamplesStraightMotionsFinely) {
  const auto path = executeToolPoints(points({{0, 0, 0}, {10, 0, 0}, {10, 3, 0}}, 20), {});
  EXPECT_FALSE(path.arm);
  ASSERT_EQ(path.motionCount(), 3u);
  EXPECT_NEAR(path.durationS[1], 0.5, 1e-12);
  EXPECT_NEAR(path.totalS(), 0.65, 1e-12);
  for (std::size_t s = 1; s < path.tip.size(); ++s)
    EXPECT_LE((path.tip[s] - path.tip[s - 1]).norm(), 0.5 + 1e-9);
  EXPECT_NEAR((path.tip.back() - Vector3d(10, 3, 0)).norm(), 0.0, 1e-12);
}

TEST(ExecutedPath, ABlendCutsItsCornerByTheParabola) {
  const double r = 2.0;
  const auto path = executeToolPoints(points({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 20, r), {});
  double nearest = 1e9;
  for (const Vector3d& p : path.tip)
    nearest = std::min(nearest, (p - Vector3d(10, 0, 0)).norm());
  // r/2 sin(turn/2) at a right angle.
  EXPECT_NEAR(nearest, 0.5 * r * std::sin(0.25 * base::kPi), 1e-9);
}

TEST(ExecutedPath, FindsOverlappingBlends) {
  const auto path =
      executeToolPoints(points({{0, 0, 0}, {10, 0, 0}, {12, 0, 0}, {12, 9, 0}}, 20, 1.5), {});
  ASSERT_EQ(path.violations.size(), 1u);
  EXPECT_EQ(path.violations[0].kind, LimitKind::BlendOverlap);
  EXPECT_EQ(path.violations[0].motion, 2u);
}

TEST(ExecutedPath, DirectionsTurnEvenly) {
  plan::ReadProgram program = points({{0, 0, 0}, {4, 0, 0}}, 10);
  program.motions[1].direction = Vector3d::UnitX();
  const auto path = executeToolPoints(program, {});
  const std::size_t first = path.firstSample[1], n = path.tip.size() - first;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 0.5 * base::kPi * static_cast<double>(k + 1) / static_cast<double>(n);
    EXPECT_NEAR(path.direction[first + k].dot(Vector3d(std::sin(angle), 0, std::cos(angle))), 1.0,
                1e-9);
  }
}

TEST(ExecutedPath, AnArmFollowsPosesAsItFollowsJoints) {
  const test::Scene s = test::boxScene(1);
  plan::ReadProgram byJoints, byPose;
  byPose.flange_T_tcp = s.cell.flange_T_moved();
  for (std::size_t j = 0; j < s.trajectory.pointCount(); ++j) {
    plan::ProgramMotion m;
    m.joints.assign(s.trajectory.at(j), s.trajectory.at(j) + s.trajectory.dof);
    m.jointInterpolated = s.trajectory.move[j] == plan::MoveKind::Joint;
    m.durationS = j == 0 ? 0.0 : s.trajectory.timeS[j] - s.trajectory.timeS[j - 1];
    byJoints.motions.push_back(m);
    if (j > 0) { // the first target fixes the configuration
      m.target = plan::TargetKind::FlangePose;
      const robot::JointVector q =
          Eigen::Map<const Eigen::VectorXd>(s.trajectory.at(j), s.trajectory.dof);
      m.frame_T_tcp = s.cell.robot().kinematics->flange(q) * byPose.flange_T_tcp;
    }
    byPose.motions.push_back(m);
  }
  const auto a = executeProgram(byJoints, s.cell, {});
  const auto b = executeProgram(byPose, s.cell, {});
  EXPECT_TRUE(a.arm && b.arm);
  EXPECT_TRUE(a.violations.empty());
  EXPECT_TRUE(b.violations.empty());
  ASSERT_EQ(a.tip.size(), b.tip.size());
  for (std::size_t k = 0; k < a.joints.size(); ++k)
    ASSERT_NEAR(a.joints[k], b.joints[k], 1e-6);
  for (std::size_t k = 0; k < a.tip.size(); ++k)
    ASSERT_NEAR((a.tip[k] - b.tip[k]).norm(), 0.0, 1e-6);
  EXPECT_NEAR(a.totalS(), s.trajectory.timeS.back(), 1e-9);
}

TEST(ExecutedPath, TargetOutOfReachIsAViolation) {
  const test::Scene s = test::boxScene(1);
  plan::ReadProgram program;
  plan::ProgramMotion m;
  m.joints.assign(s.trajectory.at(0), s.trajectory.at(0) + s.trajectory.dof);
  program.motions.push_back(m);
  m.target = plan::TargetKind::FlangePose;
  m.frame_T_tcp = Eigen::Isometry3d(Eigen::Translation3d(3000, 0, 0));
  m.speedMmPerS = 20;
  program.motions.push_back(m);
  m.target = plan::TargetKind::Joints;
  m.joints.pop_back();
  program.motions.push_back(m);
  const auto path = executeProgram(program, s.cell, {});
  std::set<std::size_t> out;
  for (const LimitViolation& v : path.violations)
    if (v.kind == LimitKind::OutOfReach)
      out.insert(v.motion);
  EXPECT_EQ(out, (std::set<std::size_t>{1, 2}));
}

} // namespace
} // namespace voluta::replay
