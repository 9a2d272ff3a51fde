// Programs for a rod that turns: a work frame that moves, and a ground that is round.
#include "base/run_context.h"
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/controller_time.h"
#include "replay/executed_path.h"
#include "replay/replay_ground.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>
#include <string>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

const test::Scene& scene() {
  static const test::Scene s = test::rodScene();
  return s;
}

robot::JointVector jointsOf(const test::Scene& s, std::size_t point) {
  return Eigen::Map<const Eigen::VectorXd>(s.trajectory.at(point), s.trajectory.dof);
}

// The trajectory as targets of the given kind; motions from rest stay joints.
plan::ReadProgram programOf(const test::Scene& s, plan::TargetKind kind) {
  plan::ReadProgram program;
  program.complete = true;
  program.flange_T_tcp = s.cell.flange_T_moved();
  for (std::size_t j = 0; j < s.trajectory.pointCount(); ++j) {
    plan::ProgramMotion m;
    m.line = j + 1;
    m.jointInterpolated = s.trajectory.move[j] == plan::MoveKind::Joint;
    m.target = m.jointInterpolated ? plan::TargetKind::Joints : kind;
    const robot::JointVector q = jointsOf(s, j);
    if (m.target == plan::TargetKind::Joints)
      m.joints.assign(q.data(), q.data() + q.size());
    m.frame_T_tcp = s.cell.work_T_tool(q);
    m.externals.assign(q.data() + s.cell.armDof(), q.data() + q.size());
    m.extruding = s.trajectory.move[j] == plan::MoveKind::Print;
    if (j > 0) {
      m.durationS = s.trajectory.timeS[j] - s.trajectory.timeS[j - 1];
      m.volumeMm3 = s.trajectory.extrudedMm3[j] - s.trajectory.extrudedMm3[j - 1];
    }
    program.motions.push_back(std::move(m));
  }
  return program;
}

Verification replayed(const test::Scene& s, const plan::ReadProgram& program) {
  return replayProgram(
      {program, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
      ReplayThresholds{}, base::RunContext());
}

bool tells(const Verification& v, const std::string& kind, const std::string& words = "") {
  return std::any_of(v.findings.begin(), v.findings.end(), [&](const plan::Finding& f) {
    return voluta::plan::reportId(f) == kind &&
           voluta::plan::englishReason(f).find(words) != std::string::npos;
  });
}

TEST(Rod, PosesInTheWorkFrameAndJointsAreTheSameMotion) {
  const test::Scene& s = scene();
  const ExecutedPath byPose =
      executeProgram(programOf(s, plan::TargetKind::WorkPose), s.cell, base::RunContext());
  const ExecutedPath byJoints =
      executeProgram(programOf(s, plan::TargetKind::Joints), s.cell, base::RunContext());
  EXPECT_TRUE(byPose.arm);
  EXPECT_EQ(byPose.armDof, 6);
  EXPECT_TRUE(byPose.violations.empty());
  EXPECT_TRUE(byJoints.violations.empty());
  ASSERT_EQ(byPose.joints.size(), byJoints.joints.size());
  for (std::size_t k = 0; k < byPose.joints.size(); ++k)
    ASSERT_NEAR(byPose.joints[k], byJoints.joints[k], 1e-9);
  ASSERT_EQ(byPose.tip.size(), byJoints.tip.size());
  for (std::size_t k = 0; k < byPose.tip.size(); ++k)
    ASSERT_NEAR((byPose.tip[k] - byJoints.tip[k]).norm(), 0.0, 1e-9);
  // Between targets the arm's poses keep the nozzle on its line while the rod turns.
  double turned = 0.0;
  for (std::size_t a = 1; a < byPose.armMotion.size(); ++a) {
    const std::size_t m = byPose.armMotion[a];
    if (m == 1)
      continue; // From beside the print; the rod rests.
    const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(
        byPose.armJoints.data() + a * static_cast<std::size_t>(byPose.dof), byPose.dof);
    const Vector3d& from = byPose.targetTip[m - 1];
    const Vector3d on = from + byPose.armFraction[a] * (byPose.targetTip[m] - from);
    ASSERT_NEAR((s.cell.work_T_tool(q).translation() - on).norm(), 0.0, 1e-6);
    turned = std::max(turned, std::abs(q[6]));
  }
  EXPECT_GT(turned, 14.0 * 2.0 * base::kPi);
}

TEST(Rod, TheWindingPasses) {
  const Verification v = replayed(scene(), programOf(scene(), plan::TargetKind::WorkPose));
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(v.armChecked);
  EXPECT_LE(v.maxDeviationMm, 1e-6);
  EXPECT_EQ(v.unsupportedFraction, 0.0);
  EXPECT_LE(v.overfillFraction, 0.01);
}

TEST(Rod, AJointTablePasses) {
  const test::Scene& s = scene();
  const plan::Program program = program::writeProgram(
      "csv", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "tube"});
  EXPECT_NE(program.files[0].text.find("j7_deg"), std::string::npos);
  const Verification v =
      replayed(s, program::readProgram("csv", program.files, process::Tooling(s.process)));
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(v.armChecked);
}

// A program's text, changed at the line of a trajectory point.
Verification replayedRapid(const test::Scene& s, std::size_t point,
                           const std::function<void(std::string&)>& change, std::size_t& line) {
  plan::Program program = program::writeProgram(
      "rapid", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "tube"});
  line = program::readProgram("rapid", program.files, process::Tooling(s.process))
             .motions.at(point)
             .line;
  std::string& text = program.files[0].text;
  std::size_t begin = 0;
  for (std::size_t k = 1; k < line; ++k)
    begin = text.find('\n', begin) + 1;
  std::string changed = text.substr(begin, text.find('\r', begin) - begin);
  const std::size_t length = changed.size();
  change(changed);
  text.replace(begin, length, changed);
  return replayed(s, program::readProgram("rapid", program.files, process::Tooling(s.process)));
}

TEST(Rod, RapidPasses) {
  std::size_t line = 0;
  const Verification v = replayedRapid(
      scene(), 5, [](std::string&) {}, line);
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(v.armChecked);
  EXPECT_LE(v.maxDeviationMm, 0.02); // rounding allowed to blends
}

// The arm hardly moves while the rod turns on to where the next bead begins: its speed is the
// rod's.
TEST(Rod, ATransferOfTheRodTakesItsTimeInEveryDialect) {
  test::Scene s = scene();
  plan::Trajectory& t = s.trajectory;
  const auto rod = static_cast<std::size_t>(t.dof) - 1;
  for (int k = 0; k < 40; ++k) {
    std::vector<double> q(t.at(t.pointCount() - 1), t.at(t.pointCount() - 1) + t.dof);
    q[0] += base::degreesToRadians(k % 2 == 0 ? 0.2 : -0.2);
    q[rod] += base::degreesToRadians(k % 2 == 0 ? 56.25 : -56.25);
    t.joints.insert(t.joints.end(), q.begin(), q.end());
    t.timeS.push_back(t.timeS.back() + 2.0);
    t.move.push_back(plan::MoveKind::Joint);
    t.waypoint.push_back(plan::kNoWaypoint);
    t.extrudedMm3.push_back(t.extrudedMm3.back());
  }
  int tried = 0;
  for (const program::Dialect& dialect : program::dialects()) {
    if (!dialect.supportsExternalAxes)
      continue;
    const plan::Program program =
        program::writeProgram(dialect.id, {s.plan, t, s.cell, process::Tooling(s.process), "tube"});
    const plan::ReadProgram read =
        program::readProgram(dialect.id, program.files, process::Tooling(s.process));
    ASSERT_TRUE(read.defects.empty()) << dialect.id;
    const ExecutedPath path = executeProgram(read, s.cell, base::RunContext());
    const std::vector<double> seconds = controllerTimes(read, path, RotationLaw::Text);
    const double all = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    EXPECT_NEAR(all, t.timeS.back(), 0.1 * t.timeS.back()) << dialect.id;
    ++tried;
  }
  EXPECT_GE(tried, 4);
}

TEST(Rod, RapidWithTheRodOneStepOffOrADotMovedIsFound) {
  const test::Scene& s = scene();
  // The angle in the text, with its step or its decimal point elsewhere.
  const auto angleAt = [](std::string& text, const std::function<std::string(std::string)>& f) {
    const std::size_t end = text.find(",9E9"), begin = text.rfind('[', end) + 1;
    text.replace(begin, end - begin, f(text.substr(begin, end - begin)));
  };
  const std::function<std::string(std::string)> steps[] = {
      [](const std::string& angle) { return std::to_string(std::stod(angle) + 0.1125); },
      [](const std::string& angle) { return std::to_string(std::stod(angle) * 10.0); }};
  for (const auto& f : steps) {
    std::size_t line = 0;
    const Verification v = replayedRapid(
        s, 500, [&](std::string& text) { angleAt(text, f); }, line);
    EXPECT_FALSE(v.passed);
    const auto found =
        std::find_if(v.findings.begin(), v.findings.end(), [](const plan::Finding& finding) {
          return voluta::plan::reportId(finding) == "externalAxisMoved";
        });
    ASSERT_NE(found, v.findings.end()) << findingsText(v);
    EXPECT_EQ(v.places[static_cast<std::size_t>(found - v.findings.begin())].line, line);
  }
}

TEST(Rod, HeldStillAPoseIsOneInBase) {
  test::Scene s = scene();
  // The beginning of one ring, deposited with the rod at rest at its angle.
  constexpr std::size_t kPoints = 12;
  plan::ReadProgram byWork = programOf(s, plan::TargetKind::WorkPose);
  byWork.motions.resize(kPoints);
  plan::ReadProgram byBase = byWork;
  for (std::size_t j = 1; j < kPoints; ++j) {
    byWork.motions[j].externals = byWork.motions[1].externals;
    byBase.motions[j].target = plan::TargetKind::FlangePose;
    byBase.motions[j].externals.clear(); // they would be values of axes under the robot
    byBase.motions[j].frame_T_tcp =
        s.cell.base_T_work(jointsOf(s, 1)) * byWork.motions[j].frame_T_tcp;
  }
  const ExecutedPath a = executeProgram(byWork, s.cell, base::RunContext());
  const ExecutedPath b = executeProgram(byBase, s.cell, base::RunContext());
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t k = 0; k < a.joints.size(); ++k)
    ASSERT_NEAR(a.joints[k], b.joints[k], 1e-9);
  ASSERT_EQ(a.tip.size(), b.tip.size());
  for (std::size_t k = 0; k < a.tip.size(); ++k)
    ASSERT_NEAR((a.tip[k] - b.tip[k]).norm(), 0.0, 1e-9);
}

TEST(Rod, OneStepOffItsPlanIsFound) {
  const test::Scene& s = scene();
  plan::ReadProgram program = programOf(s, plan::TargetKind::WorkPose);
  program.motions[100].externals[0] += s.cell.externalAxes()[0].step;
  const Verification v = replayed(s, program);
  EXPECT_FALSE(v.passed);
  ASSERT_EQ(v.deviations, 1u) << findingsText(v);
  EXPECT_EQ(voluta::plan::reportId(v.findings[0]), "externalAxisMoved");
  EXPECT_EQ(v.places[0].line, 101u);
}

TEST(Rod, ItsRangeAndSpeedAreLimits) {
  const test::Scene& s = scene();
  plan::ReadProgram program = programOf(s, plan::TargetKind::WorkPose);
  program.motions[50].externals[0] = 1.01 * s.cell.limits()[6].max;
  const Verification far = replayed(s, program);
  EXPECT_TRUE(tells(far, "limit", "rod at 3636000.0 degrees, beyond its limit of 3600000.0"));
  program = programOf(s, plan::TargetKind::WorkPose);
  // 4 degrees at 2.75 mm are 720 degrees a second at 34.6 mm/s.
  const auto timed = [&](double mmPerS) {
    for (std::size_t j = 2; j < 60; ++j)
      program.motions[j].durationS = 2.75 * base::degreesToRadians(4.0) / mmPerS;
    return executeProgram(program, s.cell, base::RunContext()).violations;
  };
  EXPECT_TRUE(timed(34.0).empty());
  const std::vector<LimitViolation> fast = timed(37.0);
  ASSERT_FALSE(fast.empty());
  EXPECT_EQ(fast[0].kind, LimitKind::JointSpeed);
  EXPECT_EQ(fast[0].joint, 6);
}

TEST(Rod, WholeStepsAreNoSpeed) {
  const test::Scene& s = scene();
  plan::ReadProgram program = programOf(s, plan::TargetKind::WorkPose);
  const double step = s.cell.externalAxes()[0].step;
  // A turn of 1.2 steps in the time that it needs at full speed, rounded to 2.
  for (std::size_t j = 3; j < 40; ++j) {
    program.motions[j].externals[0] =
        program.motions[2].externals[0] - step * std::round(1.2 * static_cast<double>(j - 2));
    program.motions[j].frame_T_tcp = program.motions[2].frame_T_tcp;
    program.motions[j].durationS = 1.2 * step / s.cell.limits()[6].velocity;
  }
  program.motions.resize(40);
  for (const LimitViolation& v : executeProgram(program, s.cell, base::RunContext()).violations)
    EXPECT_NE(v.joint, 6) << v.motion << " at " << v.value;
}

TEST(Rod, TargetsOfAnotherCellAreOutOfReach) {
  const test::Scene& s = scene();
  plan::ReadProgram program = programOf(s, plan::TargetKind::WorkPose);
  program.motions[7].externals.clear();
  program.motions[9].externals.push_back(0.0);
  program.motions[0].joints.pop_back();
  std::vector<std::size_t> out;
  for (const LimitViolation& v : executeProgram(program, s.cell, base::RunContext()).violations)
    if (v.kind == LimitKind::OutOfReach)
      out.push_back(v.motion);
  EXPECT_EQ(out, (std::vector<std::size_t>{0, 7, 9}));
}

// Controllers state values for all axes that they could have.
TEST(Rod, FurtherAxesOfATargetRestOrItIsOutOfReach) {
  const test::Scene& s = scene();
  plan::ReadProgram program = programOf(s, plan::TargetKind::WorkPose);
  std::vector<double>& joints = program.motions[0].joints;
  program.motions[0].externals.assign(joints.begin() + s.cell.armDof(), joints.end());
  const auto outOfReach = [&] {
    const auto violations = executeProgram(program, s.cell, base::RunContext()).violations;
    return std::ranges::count(violations, LimitKind::OutOfReach, &LimitViolation::kind);
  };
  EXPECT_EQ(outOfReach(), 0);
  joints.push_back(0.0);
  EXPECT_EQ(outOfReach(), 0);
  joints.back() = 1.0;
  EXPECT_EQ(outOfReach(), 1);
}

TEST(Rod, ABeadOverTheRodIsUnsupportedAndABearingIsInTheWay) {
  test::Scene s = scene();
  for (std::size_t w = 0; w < s.plan.waypointCount(); ++w)
    s.plan.position[w] += 0.35 * s.process.layerHeightMm * s.plan.direction[w];
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  const Verification over = replayed(s, programOf(s, plan::TargetKind::WorkPose));
  const double first = 2.75 + 0.0875, second = first + 0.25; // tips' radii, by which beads are long
  EXPECT_NEAR(over.unsupportedFraction, first / (first + second), 0.005);
  s = scene();
  for (Vector3d& p : s.plan.position)
    p.x() += 106.0;
  for (Vector3d& v : s.part.vertices)
    v.x() += 106.0;
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  const Verification beside = replayed(s, programOf(s, plan::TargetKind::WorkPose));
  EXPECT_TRUE(tells(beside, "collision", "head and")) << findingsText(beside);
  EXPECT_TRUE(tells(beside, "collision", "bearing and printed part")) << findingsText(beside);
}

TEST(Ground, RodSupportsPointsWithinIt) {
  platform::PlatformSolid platform;
  platform.rod = platform::straightRod(5.0, 100.0);
  const GroundProbe round(platform);
  EXPECT_TRUE(round.holds({20, 0, 2.5}, 0.1));
  EXPECT_TRUE(round.holds({-20, -1.7, -1.7}, 0.1));
  EXPECT_FALSE(round.holds({20, 0, 2.51}, 0.1));
  EXPECT_TRUE(round.holds({50.05, 0, 2}, 0.1));
  EXPECT_FALSE(round.holds({50.2, 0, 2}, 0.1));
  platform.rod = platform::straightRod(5.0, 100.0, 6);
  const GroundProbe hexagonal(platform);
  const double flat = 2.5 * std::sqrt(3.0) / 2.0;
  EXPECT_TRUE(hexagonal.holds({0, 2.499, 0}, 0.0));
  EXPECT_FALSE(hexagonal.holds({0, 0, 2.2}, 0.0)); // the middle of a side
  EXPECT_TRUE(hexagonal.holds({0, 0, flat - 1e-3}, 0.0));
  EXPECT_FALSE(hexagonal.holds({0, 0, flat + 1e-3}, 0.0));
  EXPECT_TRUE(hexagonal.holds({0, -1.249, -flat + 1e-3}, 0.0));
  platform.rod = platform::RodShape{{{-10, 2}, {0, 2}, {0, 4}, {10, 5}}, 0};
  const GroundProbe stepped(platform);
  EXPECT_FALSE(stepped.holds({-1, 0, 3}, 0.0));
  EXPECT_TRUE(stepped.holds({0, 0, 3.9}, 0.0));
  EXPECT_TRUE(stepped.holds({5, 0, 4.49}, 0.0));
  EXPECT_FALSE(stepped.holds({5, 0, 4.51}, 0.0));
}

// The plate's box of material, on a block that is itself the ground.
test::Scene onABlock() {
  test::Scene s = test::boxScene(2);
  const double up = 10.0;
  for (Vector3d& p : s.plan.position)
    p.z() += up;
  for (Vector3d& v : s.part.vertices)
    v.z() += up;
  s.platform.mesh = std::make_shared<geometry::TriangleMesh>(test::box({-9, -9, 0}, {9, 9, up}));
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  return s;
}
Verification replayedTable(const test::Scene& s) {
  const plan::Program program = program::writeProgram(
      "csv", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  return replayed(s, program::readProgram("csv", program.files, process::Tooling(s.process)));
}

TEST(Ground, ABodyCarriesBeads) {
  test::Scene s = onABlock();
  const Verification v = replayedTable(s);
  EXPECT_TRUE(v.passed) << findingsText(v);
  s.platform.mesh = nullptr;
  EXPECT_NEAR(replayedTable(s).unsupportedFraction, 0.5, 1e-6); // the first of two layers
  s = onABlock();
  for (Vector3d& p : s.plan.position)
    p.z() += 0.35 * s.process.layerHeightMm;
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  EXPECT_NEAR(replayedTable(s).unsupportedFraction, 0.5, 0.02);
}

TEST(Ground, AHeadInABodyCollides) {
  test::Scene s = onABlock();
  test::addPath(s.plan, {{7.5, -7, 8.5}, {7.5, 7, 8.5}}, 1.2, 0.8, 20, 9);
  s.trajectory = test::walk(s.plan, s.cell, s.process, 12.0);
  const Verification v = replayedTable(s);
  EXPECT_TRUE(tells(v, "collision", "head and platform")) << findingsText(v);
}

} // namespace
} // namespace voluta::replay
