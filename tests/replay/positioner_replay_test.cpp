// Programs for a plate that tilts and turns under the nozzle.
#include "base/run_context.h"
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/executed_path.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace voluta::replay {
namespace {

robot::JointVector jointsOf(const plan::Trajectory& t, std::size_t point) {
  return Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof);
}
void setJoints(plan::Trajectory& t, std::size_t point, const robot::JointVector& q) {
  std::copy(q.data(), q.data() + q.size(),
            t.joints.begin() + static_cast<std::ptrdiff_t>(point) * t.dof);
}

// The box, printed while the plate tilts to 20 and turns to 90 degrees and back.
const test::Scene& scene() {
  static const test::Scene made = [] {
    test::Scene s = test::boxScene(2, "irb1200-irbp");
    plan::Trajectory& t = s.trajectory;
    std::vector<robot::JointVector> solutions;
    robot::JointVector near = jointsOf(t, 0);
    const std::size_t n = t.pointCount();
    for (std::size_t i = 0; i < n; ++i) {
      const robot::JointVector q = jointsOf(t, i);
      const double share =
          std::sin(base::kPi * static_cast<double>(i) / static_cast<double>(n - 1));
      robot::JointVector there = near;
      there.tail(2) << base::degreesToRadians(20.0 * share), base::degreesToRadians(90.0 * share);
      s.cell.inverse(s.cell.work_T_tool(q), there, solutions);
      base::require(!solutions.empty(), "scene: in reach");
      near =
          *std::min_element(solutions.begin(), solutions.end(), [&](const auto& a, const auto& b) {
            return (a - there).squaredNorm() < (b - there).squaredNorm();
          });
      setJoints(t, i, near);
    }
    return s;
  }();
  return made;
}

Verification replayed(const test::Scene& s, const plan::ReadProgram& program) {
  return replayProgram(
      {program, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
      ReplayThresholds{}, base::RunContext());
}

plan::ReadProgram programOf(const test::Scene& s, const std::string& format) {
  const plan::Program written = program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  return program::readProgram(format, written.files, process::Tooling(s.process));
}

TEST(Positioner, ABoxPrintedOnAMovingPlatePasses) {
  for (const char* format : {"rapid", "csv"}) {
    const Verification v = replayed(scene(), programOf(scene(), format));
    EXPECT_TRUE(v.passed) << format << findingsText(v);
    EXPECT_TRUE(v.armChecked) << format;
    EXPECT_LE(v.maxDeviationMm, 0.02) << format;
    EXPECT_EQ(v.collisions, 0u) << format;
  }
}

// Straight on the part, whatever the axes do: the arm makes up for them.
TEST(Positioner, TheNozzleStaysOnItsLineWhileThePlateMoves) {
  const ExecutedPath path =
      executeProgram(programOf(scene(), "rapid"), scene().cell, base::RunContext());
  ASSERT_EQ(path.dof, 8);
  EXPECT_EQ(path.armDof, 6);
  EXPECT_TRUE(path.violations.empty());
  for (std::size_t a = 1; a < path.armMotion.size(); ++a) {
    const std::size_t m = path.armMotion[a];
    if (m == 0)
      continue;
    const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(
        path.armJoints.data() + a * static_cast<std::size_t>(path.dof), path.dof);
    const Eigen::Vector3d& from = path.targetTip[m - 1];
    const Eigen::Vector3d on = from + path.armFraction[a] * (path.targetTip[m] - from);
    ASSERT_NEAR((scene().cell.work_T_tool(q).translation() - on).norm(), 0.0, 1e-5);
  }
}

TEST(Positioner, AnAxisElsewhereIsFound) {
  for (const std::size_t axis : {0u, 1u}) {
    plan::ReadProgram program = programOf(scene(), "rapid");
    program.motions.at(60).externals.at(axis) += base::degreesToRadians(0.05);
    const Verification v = replayed(scene(), program);
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
      return plan::reportId(f) == "externalAxisMoved";
    })) << findingsText(v);
  }
}

TEST(Positioner, APlateThatTiltsIntoTheArmIsFound) {
  test::Scene s = scene();
  plan::Trajectory& t = s.trajectory;
  // Behind the last bead the plate tilts far over while the arm stays above it.
  const std::size_t last = t.pointCount() - 1;
  robot::JointVector q = jointsOf(t, last);
  q[6] = base::degreesToRadians(150);
  t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
  t.timeS.push_back(t.timeS.back() + 5.0);
  t.move.push_back(plan::MoveKind::Joint);
  t.waypoint.push_back(plan::kNoWaypoint);
  t.extrudedMm3.push_back(t.extrudedMm3.back());
  const Verification v = replayed(s, programOf(s, "csv"));
  EXPECT_FALSE(v.passed);
  EXPECT_GE(v.collisions, 1u) << findingsText(v);
}

} // namespace
} // namespace voluta::replay
