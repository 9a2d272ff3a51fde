// Controllers' times for given speeds: closed forms, and programs whose flow would be wrong.
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/controller_time.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/section_errors.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <regex>

namespace voluta::replay {
namespace {

// Tip motions through these points at a speed, an acceleration and blends.
plan::ReadProgram through(const std::vector<Eigen::Vector3d>& points, double speed,
                          double acceleration, double blend) {
  plan::ReadProgram p;
  for (std::size_t i = 0; i < points.size(); ++i) {
    plan::ProgramMotion m;
    m.line = i + 1;
    m.target = plan::TargetKind::ToolPoint;
    m.position = points[i];
    m.speedMmPerS = speed;
    m.accelerationMmPerS2 = acceleration;
    m.blendMm = i > 0 && i + 1 < points.size() ? blend : 0.0;
    m.extruding = i > 0;
    m.flowMm3PerS = 1.0;
    p.motions.push_back(m);
  }
  return p;
}

std::vector<double> times(const plan::ReadProgram& p, RotationLaw law = RotationLaw::Text) {
  return controllerTimes(p, executeToolPoints(p, {}), law);
}
double total(const std::vector<double>& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

TEST(ControllerTime, AMotionFromRestToRestIsATrapezoid) {
  // Up to 20 mm/s at 500 mm/s2: 0.4 mm and 0.04 s at either end.
  EXPECT_NEAR(times(through({{0, 0, 0}, {10, 0, 0}}, 20, 500, 0))[1], 10.0 / 20 + 0.04, 1e-12);
  // Too short for the speed: a triangle.
  EXPECT_NEAR(times(through({{0, 0, 0}, {0.2, 0, 0}}, 20, 500, 0))[1], 2 * std::sqrt(0.2 / 500),
              1e-12);
  // At once.
  EXPECT_NEAR(times(through({{0, 0, 0}, {10, 0, 0}}, 20, 0, 0))[1], 0.5, 1e-12);
}

TEST(ControllerTime, BlendsOnAStraightLineCostNoTime) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 100; ++i)
    points.emplace_back(0.3 * i, 0, 0);
  EXPECT_NEAR(total(times(through(points, 20, 500, 0.1))), 30.0 / 20 + 0.04, 1e-9);
  // Without blends the arm stops at each point.
  EXPECT_NEAR(total(times(through(points, 20, 500, 0.0))), 100 * 2 * std::sqrt(0.3 / 500), 1e-9);
  // Where the controller looks one motion ahead, it can't be faster than it brakes within one.
  plan::ReadProgram shortSighted = through(points, 20, 500, 0.1);
  shortSighted.time.lookAhead = 1;
  const double maximum = std::sqrt(2 * 500 * 0.3);
  EXPECT_NEAR(times(shortSighted)[50], 0.3 / maximum, 0.3 / maximum * 0.1);
  EXPECT_GT(total(times(shortSighted)), 30.0 / 20 + 0.04);
}

TEST(ControllerTime, CornerSpeedFollowsTheBlendRadius) {
  // A right angle, r = 0.1 mm at 500 mm/s2: sqrt(500 x 0.1 / sin 45) = 8.41 mm/s.
  const double corner = std::sqrt(500 * 0.1 / std::sin(base::kPi / 4));
  const auto s = times(through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 20, 500, 0.1));
  const double expected =
      20.0 / 500 + (20 - corner) / 500 +
      (10 - 0.4 - (400 - corner * corner) / 1000) / 20; // up, down to the corner, between
  EXPECT_NEAR(s[1], expected, 1e-9);
  EXPECT_NEAR(s[2], expected, 1e-9);
}

TEST(ControllerTime, TimeRulesOverSpeedAndAcceleration) {
  plan::ReadProgram p = through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 0, 1, 0.1);
  for (plan::ProgramMotion& m : p.motions)
    m.durationS = 0.5;
  EXPECT_EQ(times(p)[1], 0.5);
  EXPECT_EQ(times(p, RotationLaw::PathSpeed)[2], 0.5);
  p.time.cycleS = 0.6;
  EXPECT_EQ(times(p)[1], 0.6);
}

TEST(ControllerTime, JunctionsAreThoseOfAFirmware) {
  plan::ReadProgram p = through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 20, 0, 0);
  p.time = {.accelerationMmPerS2 = 3000, .junctionMm = 0.013};
  const double c = std::cos(base::kPi / 4), corner = std::sqrt(3000 * 0.013 * c / (1 - c));
  EXPECT_NEAR(times(p)[2],
              (20 - corner) / 3000 + 20.0 / 3000 +
                  (10 - (400 - corner * corner) / 6000 - 400.0 / 6000) / 20,
              1e-9);
}

// Against a controller of many small steps of time that obeys the same limits.
TEST(ControllerTime, ASteppedControllerNeedsAsLong) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    const double a = 200 + 800 * unit(random);
    std::vector<Eigen::Vector3d> points = {{0, 0, 0}};
    for (int i = 0; i < 40; ++i)
      points.emplace_back(points.back().x() + 0.2 + 2 * unit(random), 0, 0);
    plan::ReadProgram p = through(points, 0, a, 0.05);
    for (plan::ProgramMotion& m : p.motions)
      m.speedMmPerS = 5 + 30 * unit(random);
    // Greatest speed at each place of a fine grid, forth and back.
    constexpr double kStep = 1e-3;
    const auto cells = static_cast<std::size_t>(points.back().x() / kStep);
    std::vector<double> v(cells + 1, 0.0);
    for (std::size_t i = 0; i < cells; ++i) {
      const double x = (static_cast<double>(i) + 0.5) * kStep;
      std::size_t m = 1;
      while (points[m].x() < x)
        ++m;
      v[i] = std::min(p.motions[m].speedMmPerS,
                      std::sqrt((i ? v[i - 1] * v[i - 1] : 0.0) + 2 * a * kStep));
    }
    double seconds = 0.0, next = 0.0;
    for (std::size_t i = cells; i-- > 0;) {
      next = v[i] = std::min(v[i], std::sqrt(next * next + 2 * a * kStep));
      seconds += kStep / v[i];
    }
    EXPECT_NEAR(total(times(p)), seconds, 0.02 * seconds);
  }
}

// ---- whole programs

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}
Verification verify(const test::ProgramText& text) {
  const test::Scene& s = scene();
  return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                        process::Tooling(s.process), s.part, s.platform},
                       ReplayThresholds{}, {});
}
test::ProgramText textOf(const std::string& format) {
  const test::Scene& s = scene();
  return test::textOf(program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"}));
}
// Straight motions by a speed in place of a time.
test::ProgramText bySpeeds(test::ProgramText text, const std::string& acceleration) {
  const plan::ReadProgram read = test::read(text, scene().process);
  const ExecutedPath path = executeProgram(read, scene().cell, {});
  static const std::regex kTimed("a=[0-9.]+,t=[0-9.]+");
  for (std::size_t m = 1; m < read.motions.size(); ++m)
    if (read.motions[m].durationS > 0.0) {
      std::string& line = text.lines[read.motions[m].line - 1];
      line = std::regex_replace(
          line, kTimed,
          "a=" + acceleration +
              ",v=" + std::to_string(path.commandedMm[m] / read.motions[m].durationS / 1000.0));
    }
  return text;
}

TEST(ControllerTime, OurProgramsDepositThePlannedVolumeUnderBothLaws) {
  for (const program::Dialect& d : test::dialectsFor("urscript")) {
    const Verification v = verify(textOf(std::string(d.id)));
    EXPECT_LE(v.flowErrorFraction, 0.01) << d.id;
    EXPECT_NEAR(v.massRatio, 1.0, 0.01) << d.id;
    EXPECT_NEAR(v.durationS, scene().trajectory.timeS.back(),
                0.15 * scene().trajectory.timeS.back())
        << d.id;
    EXPECT_TRUE(v.passed) << d.id << findingsText(v);
  }
  const plan::ReadProgram p = test::read(textOf("urscript"), scene().process);
  const ExecutedPath path = executeProgram(p, scene().cell, {});
  const double text = total(controllerTimes(p, path, RotationLaw::Text));
  EXPECT_NEAR(total(controllerTimes(p, path, RotationLaw::PathSpeed)), text, 0.05 * text);
}

TEST(ControllerTime, AProgramThatWouldPrintForWeeksIsRefused) {
  const Verification v = verify(bySpeeds(textOf("urscript"), "0.01"));
  EXPECT_FALSE(v.passed);
  EXPECT_GT(v.flowErrorFraction, 0.9);
  EXPECT_GT(v.massRatio, 1.5);
  EXPECT_GT(v.durationS, 2.0 * scene().trajectory.timeS.back());
  EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::FlowErrors;
  })) << findingsText(v);
}

TEST(ControllerTime, UnplannedAccelerationIsFound) {
  const test::ProgramText text = bySpeeds(textOf("urscript"), "0.5");
  const auto harder = [&](const char* acceleration) {
    test::ProgramText changed = text;
    std::string& line = changed.lines[test::read(text, scene().process).motions[8].line - 1];
    line = std::regex_replace(line, std::regex("a=0.5"), acceleration);
    const Verification v = verify(changed);
    return std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::AccelerationChanged;
    });
  };
  EXPECT_FALSE(harder("a=0.5"));
  EXPECT_TRUE(harder("a=5"));
}

TEST(ControllerTime, SpeedsThatTheTurnSlowsAreRefused) {
  // The plate turns by 0.1 rad over each millimetre: 25 mm of way by the second law.
  test::Scene s = test::boxScene(1);
  plan::ReadProgram p = test::read(bySpeeds(textOf("urscript"), "9"), s.process);
  ExecutedPath path = executeProgram(p, scene().cell, {});
  std::fill(path.angleRad.begin(), path.angleRad.end(), 0.1);
  const double text = total(controllerTimes(p, path, RotationLaw::Text));
  EXPECT_GT(total(controllerTimes(p, path, RotationLaw::PathSpeed)), 10.0 * text);
}

// A transfer in two pieces, planned through without a stop: poses of a foreign program are at the
// end of each, and take no longer for it.
TEST(ControllerTime, PiecesOfATransferTakeTheirTimeForAForeignController) {
  test::Scene s = test::boxScene(1, "tm5-moving");
  plan::Trajectory& t = s.trajectory;
  for (int k = 1; k <= 2; ++k) {
    std::vector<double> q(t.at(t.pointCount() - 1), t.at(t.pointCount() - 1) + t.dof);
    q[0] += 0.15;
    t.joints.insert(t.joints.end(), q.begin(), q.end());
    t.timeS.push_back(t.timeS.back() + 0.25);
    t.move.push_back(plan::MoveKind::Joint);
    t.waypoint.push_back(plan::kNoWaypoint);
    t.extrudedMm3.push_back(t.extrudedMm3.back());
  }
  const plan::Program program =
      program::writeProgram("urscript", {s.plan, t, s.cell, process::Tooling(s.process), "box"});
  EXPECT_TRUE(program.foreign);
  const plan::ReadProgram read =
      program::readProgram("urscript", program.files, process::Tooling(s.process));
  ASSERT_EQ(read.motions.size(), t.pointCount());
  const ExecutedPath path = executeProgram(read, s.cell, base::RunContext());
  const std::vector<double> seconds = controllerTimes(read, path, RotationLaw::Text);
  for (std::size_t m = t.pointCount() - 2; m < t.pointCount(); ++m)
    EXPECT_NEAR(seconds[m], 0.25, 0.005);
}

} // namespace
} // namespace voluta::replay
