// Results that the programs of one plan share change no verdict, whatever the dialects.
#include "base/run_context.h"
#include "pipeline/replayed/shared_runs.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/scene.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>
#include <string>

namespace voluta::pipeline {
namespace {

using replay::told;
using replay::Verification;

const test::Scene& scene() {
  static const test::Scene s = test::boxScene();
  return s;
}

test::ProgramText textOf(const std::string& format, const plan::Trajectory& trajectory) {
  const test::Scene& s = scene();
  return test::textOf(program::writeProgram(
      format, {s.plan, trajectory, s.cell, process::Tooling(s.process), "box"}));
}

replay::ReplayInput inputOf(const test::ProgramText& text, const plan::Trajectory& trajectory) {
  const test::Scene& s = scene();
  return {test::read(text, s.process), s.plan, trajectory, s.cell,
          process::Tooling(s.process), s.part, s.platform};
}

Verification alone(const test::ProgramText& text, const plan::Trajectory& trajectory) {
  return replay::replayProgram(inputOf(text, trajectory), {}, {});
}

// A point in the middle of a bead, halfway through the print.
std::size_t middlePoint() {
  const test::Scene& s = scene();
  const std::size_t waypoint = s.plan.paths[s.plan.paths.size() / 2].first + 5;
  return static_cast<std::size_t>(
      std::find(s.trajectory.waypoint.begin(), s.trajectory.waypoint.end(), waypoint) -
      s.trajectory.waypoint.begin());
}

// The scene's motion with a way round by joints amid the print: of dialects that cannot say it the
// programs have more motions than others have.
plan::Trajectory withDetour() {
  plan::Trajectory t = scene().trajectory;
  const auto dof = static_cast<std::size_t>(t.dof);
  std::size_t j = t.pointCount() / 4;
  while (t.move[j] != plan::MoveKind::Linear || t.waypoint[j] != plan::kNoWaypoint ||
         t.move[j + 1] != plan::MoveKind::Linear || t.waypoint[j + 1] != plan::kNoWaypoint)
    ++j;
  const auto insert = [j](auto& values, auto value) {
    values.insert(values.begin() + static_cast<std::ptrdiff_t>(j) + 1, value);
  };
  std::vector<double> aside(t.at(j), t.at(j) + dof);
  aside[0] += 0.4;
  for (std::size_t k = dof; k-- > 0;)
    t.joints.insert(t.joints.begin() + static_cast<std::ptrdiff_t>((j + 1) * dof), aside[k]);
  for (std::size_t i = j + 1; i < t.timeS.size(); ++i)
    t.timeS[i] += 4.0;
  insert(t.timeS, t.timeS[j] + 2.0);
  insert(t.move, plan::MoveKind::Joint);
  insert(t.waypoint, plan::kNoWaypoint);
  insert(t.extrudedMm3, t.extrudedMm3[j]);
  t.move[j + 2] = plan::MoveKind::Joint;
  return t;
}

class SharedDialects : public ::testing::TestWithParam<std::string> {};

TEST_P(SharedDialects, ResultsOfOtherProgramsChangeNoVerdict) {
  const plan::Trajectory& trajectory = scene().trajectory;
  SharedRuns others;
  for (const program::Dialect& other : test::dialectsFor("urscript"))
    if (other.id != GetParam())
      replayShared(inputOf(textOf(std::string(other.id), trajectory), trajectory), others, {});
  ASSERT_FALSE(others.runs().empty());
  const test::ProgramText text = textOf(GetParam(), trajectory);
  const auto sharing = [&](const test::ProgramText& t) {
    SharedRuns shared = others;
    return replayShared(inputOf(t, trajectory), shared, {});
  };
  const Verification own = alone(text, trajectory), borrowed = sharing(text);
  EXPECT_EQ(borrowed.passed, own.passed) << told(borrowed);
  EXPECT_NEAR(borrowed.coveredFraction, own.coveredFraction, 2e-3);
  EXPECT_NEAR(borrowed.overfillFraction, own.overfillFraction, 2e-3);
  EXPECT_EQ(borrowed.collisions, own.collisions);
  EXPECT_EQ(borrowed.maxDeviationMm, own.maxDeviationMm) << "of its own text";
  EXPECT_EQ(borrowed.armChecked, own.armChecked);
  test::ProgramText damaged = text;
  ASSERT_TRUE(test::moveTarget(damaged, middlePoint(), scene().process));
  EXPECT_FALSE(sharing(damaged).passed);
}

TEST_P(SharedDialects, AWayRoundByJointsPassesAloneAndWithResultsOfOthers) {
  const plan::Trajectory trajectory = withDetour();
  const auto text = [&](const std::string& format) {
    const test::ProgramText written = textOf(format, trajectory);
    EXPECT_EQ(test::read(written, scene().process).motions.size() > trajectory.pointCount(),
              !program::findDialect(format).saysJointMotions ||
                  test::read(written, scene().process).beadsByJoints);
    return written;
  };
  const Verification own = alone(text(GetParam()), trajectory);
  EXPECT_TRUE(own.passed) << told(own);
  for (const program::Dialect& other : test::dialectsFor("urscript")) {
    SharedRuns shared;
    replayShared(inputOf(text(std::string(other.id)), trajectory), shared, {});
    const Verification borrowed = replayShared(inputOf(text(GetParam()), trajectory), shared, {});
    EXPECT_TRUE(borrowed.passed) << other.id << told(borrowed);
    EXPECT_NEAR(borrowed.coveredFraction, own.coveredFraction, 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Pipeline, SharedDialects, ::testing::ValuesIn(test::idsFor("urscript")),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

} // namespace
} // namespace voluta::pipeline
