// Programs of one plan share the results of the beads that they have in common: only those, and
// without a change of any verdict, for all dialects and pieces of their joint motions.
#include "base/run_context.h"
#include "helpers/all_seeds.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/program_stage.h"
#include "pipeline/replay_stage.h"
#include "pipeline/replayed/shared_runs.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <string>
#include <utility>

namespace voluta::pipeline {
namespace {

using replay::findingsText;
using replay::Verification;

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

const process::Tooling& tooling() {
  static const process::Tooling t(scene().process);
  return t;
}

replay::ReplayInput inputOf(plan::ReadProgram program, const plan::Trajectory& trajectory) {
  const test::Scene& s = scene();
  return {std::move(program), s.plan, trajectory, s.cell, tooling(), s.part, s.platform};
}

ProgramStageInput stageInput(const plan::Trajectory& trajectory) {
  const test::Scene& s = scene();
  return {s.part, s.platform, s.plan, trajectory, s.cell, tooling(), "box"};
}

test::ProgramText textOf(const std::string& format, const plan::Trajectory& trajectory) {
  const test::Scene& s = scene();
  return test::textOf(
      program::writeProgram(format, {s.plan, trajectory, s.cell, tooling(), "box"}));
}

plan::ReadProgram readBack(const std::string& format, const plan::Trajectory& trajectory) {
  return test::read(textOf(format, trajectory), scene().process);
}

// ---- the same beads, and others

const plan::ReadProgram& boxProgram() {
  static const plan::ReadProgram p = readBack("gcode-extended", scene().trajectory);
  return p;
}

// Returns whether a program shares the beads of boxProgram() after this change.
bool shares(const std::function<void(plan::ReadProgram&)>& change) {
  static const SharedRuns unchanged = [] {
    SharedRuns runs;
    replayShared(inputOf(boxProgram(), scene().trajectory), {}, runs, {});
    return runs;
  }();
  SharedRuns shared = unchanged;
  plan::ReadProgram program = boxProgram();
  change(program);
  replayShared(inputOf(std::move(program), scene().trajectory), {}, shared, {});
  return shared.runs().size() == 2 && shared.runs()[0].deposited == shared.runs()[1].deposited;
}

// The motion in the middle of those that do, or do not, deposit material.
std::size_t middleOf(const plan::ReadProgram& program, bool extruding) {
  std::vector<std::size_t> found;
  for (std::size_t m = 1; m + 1 < program.motions.size(); ++m)
    if (program.motions[m].extruding == extruding)
      found.push_back(m);
  return found[found.size() / 2];
}

plan::ProgramMotion& bead(plan::ReadProgram& program) {
  return program.motions[middleOf(program, true)];
}

TEST(SharedBeads, OfTheSameBeads) {
  EXPECT_TRUE(shares([](plan::ReadProgram&) {}));
  EXPECT_TRUE(shares([](plan::ReadProgram& p) { bead(p).position.y() += 1e-3; }));
  EXPECT_TRUE(shares([](plan::ReadProgram& p) { bead(p).volumeMm3 *= 1.0 + 5e-4; }));
}

TEST(SharedBeads, WithAnotherWayBetweenBeads) {
  EXPECT_TRUE(
      shares([](plan::ReadProgram& p) { p.motions[middleOf(p, false)].position.z() += 2.0; }));
}

TEST(SharedBeads, NotOfOtherMaterial) {
  for (const double times : {0.0, 0.9, 0.998, 1.002, 1.1, 3.0})
    EXPECT_FALSE(shares([&](plan::ReadProgram& p) { bead(p).volumeMm3 *= times; })) << times;
  EXPECT_FALSE(shares([](plan::ReadProgram& p) {
    bead(p).extruding = false;
    bead(p).volumeMm3 = 0.0;
  }));
}

TEST(SharedBeads, NotWithABeadMore) {
  EXPECT_FALSE(shares([](plan::ReadProgram& p) {
    plan::ProgramMotion& travel = p.motions[middleOf(p, false)];
    travel.extruding = true;
    travel.volumeMm3 = 1.0;
  }));
  EXPECT_FALSE(shares([](plan::ReadProgram& p) {
    plan::ProgramMotion more = bead(p);
    more.position.z() += 5.0;
    p.motions.insert(p.motions.begin() + static_cast<std::ptrdiff_t>(middleOf(p, true)) + 1, more);
  }));
}

TEST(SharedBeads, NotWithABeadLess) {
  EXPECT_FALSE(shares([](plan::ReadProgram& p) {
    p.motions.erase(p.motions.begin() + static_cast<std::ptrdiff_t>(middleOf(p, true)));
  }));
}

TEST(SharedBeads, NotElsewhere) {
  EXPECT_FALSE(shares([](plan::ReadProgram& p) { bead(p).position.y() += 1.0; }));
  // Each by less than a single one may be, all together by more than they may.
  EXPECT_FALSE(shares([](plan::ReadProgram& p) {
    for (plan::ProgramMotion& m : p.motions)
      if (m.extruding)
        m.position.x() += 0.1;
  }));
}

// ---- every dialect

// A point in the middle of a bead, halfway through the print.
std::size_t middlePoint() {
  const test::Scene& s = scene();
  const std::size_t waypoint = s.plan.paths[s.plan.paths.size() / 2].first + 5;
  return static_cast<std::size_t>(
      std::find(s.trajectory.waypoint.begin(), s.trajectory.waypoint.end(), waypoint) -
      s.trajectory.waypoint.begin());
}

// The scene's motion with a detour by joints within the print: programs of dialects without joint
// motions have more motions than others.
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
  std::vector<double> offset(t.at(j), t.at(j) + dof);
  offset[0] += 0.4;
  for (std::size_t k = dof; k-- > 0;)
    t.joints.insert(t.joints.begin() + static_cast<std::ptrdiff_t>((j + 1) * dof), offset[k]);
  for (std::size_t i = j + 1; i < t.timeS.size(); ++i)
    t.timeS[i] += 4.0;
  insert(t.timeS, t.timeS[j] + 2.0);
  insert(t.move, plan::MoveKind::Joint);
  insert(t.waypoint, plan::kNoWaypoint);
  insert(t.extrudedMm3, t.extrudedMm3[j]);
  t.move[j + 2] = plan::MoveKind::Joint;
  return t;
}

const plan::Trajectory& detour() {
  static const plan::Trajectory t = withDetour();
  return t;
}

// Returns the runs of these programs, each judged with the results of those before it.
SharedRuns runsOf(const std::vector<std::string>& formats) {
  SharedRuns shared;
  for (const std::string& format : formats)
    replayShared(inputOf(readBack(format, scene().trajectory), scene().trajectory), {}, shared, {});
  return shared;
}

// Returns the runs of all dialects but one, none of them judged with its results.
SharedRuns runsWithout(const std::string& format) {
  static const std::vector<std::string> ids = test::idsFor("urscript");
  static const SharedRuns all = runsOf(ids);
  if (format == ids.front()) // the others take their results from it
    return runsOf({ids.begin() + 1, ids.end()});
  SharedRuns others;
  for (std::size_t d = 0; d < ids.size(); ++d)
    if (ids[d] != format)
      others.add(all.runs()[d]);
  return others;
}

// Returns the runs of programs with the detour, each judged alone: of all dialects, or of one
// dialect for each number of motions.
const std::map<std::string, SharedRuns>& detours() {
  static const std::map<std::string, SharedRuns> all = [] {
    std::map<std::string, SharedRuns> runs;
    std::map<std::pair<std::size_t, bool>, std::string> kinds;
    for (const std::string& format : test::idsFor("urscript")) {
      plan::ReadProgram program = readBack(format, detour());
      const bool another =
          kinds.try_emplace({program.motions.size(), program.beadsByJoints}, format).second;
      if (another || test::allSeeds())
        replayShared(inputOf(std::move(program), detour()), {}, runs[format], {});
    }
    return runs;
  }();
  return all;
}

class SharedDialects : public ::testing::TestWithParam<std::string> {};

TEST_P(SharedDialects, ResultsOfOtherProgramsChangeNoVerdict) {
  const plan::Trajectory& trajectory = scene().trajectory;
  const SharedRuns others = runsWithout(GetParam());
  ASSERT_FALSE(others.runs().empty());
  const test::ProgramText text = textOf(GetParam(), trajectory);
  const auto sharing = [&](const test::ProgramText& t) {
    SharedRuns shared = others;
    return replayShared(inputOf(test::read(t, scene().process), trajectory), {}, shared, {});
  };
  const Verification own = replay::replayProgram(
                         inputOf(test::read(text, scene().process), trajectory), {}, {}),
                     borrowed = sharing(text);
  EXPECT_EQ(borrowed.passed, own.passed) << findingsText(borrowed);
  EXPECT_NEAR(borrowed.coveredFraction, own.coveredFraction, 2e-3);
  EXPECT_NEAR(borrowed.overfillFraction, own.overfillFraction, 2e-3);
  EXPECT_EQ(borrowed.collisions, own.collisions);
  EXPECT_EQ(borrowed.maxDeviationMm, own.maxDeviationMm) << "of its own text";
  EXPECT_EQ(borrowed.armChecked, own.armChecked);
  test::ProgramText damaged = text;
  ASSERT_TRUE(test::moveTarget(damaged, middlePoint(), scene().process));
  EXPECT_FALSE(sharing(damaged).passed);
}

TEST_P(SharedDialects, ADetourByJointsPassesAloneAndWithResultsOfOthers) {
  const plan::ReadProgram program = readBack(GetParam(), detour());
  EXPECT_EQ(program.motions.size() > detour().pointCount(),
            !program::findDialect(GetParam()).saysJointMotions || program.beadsByJoints);
  const Verification own = replay::replayProgram(inputOf(program, detour()), {}, {});
  EXPECT_TRUE(own.passed) << findingsText(own);
  EXPECT_GE(detours().size(), 2u);
  for (const auto& [other, runs] : detours()) {
    SharedRuns shared = runs;
    const Verification borrowed = replayShared(inputOf(program, detour()), {}, shared, {});
    EXPECT_TRUE(borrowed.passed) << other << findingsText(borrowed);
    EXPECT_NEAR(borrowed.coveredFraction, own.coveredFraction, 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Pipeline, SharedDialects, ::testing::ValuesIn(test::idsFor("urscript")),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

// ---- joint motions in several pieces

// Returns the trajectory with each joint motion in `pieces`, on one line in joint space.
plan::Trajectory withPieces(const plan::Trajectory& whole, std::size_t pieces) {
  plan::Trajectory t;
  t.dof = whole.dof;
  const auto push = [&](std::size_t i, double share) {
    for (int j = 0; j < whole.dof; ++j)
      t.joints.push_back(
          whole.at(i)[j] -
          (share < 1.0 ? (1.0 - share) * (whole.at(i)[j] - whole.at(i - 1)[j]) : 0.0));
    t.timeS.push_back(whole.timeS[i] -
                      (i > 0 ? (1.0 - share) * (whole.timeS[i] - whole.timeS[i - 1]) : 0.0));
    t.extrudedMm3.push_back(whole.extrudedMm3[i]);
    t.move.push_back(whole.move[i]);
    t.waypoint.push_back(share < 1.0 ? plan::kNoWaypoint : whole.waypoint[i]);
  };
  for (std::size_t i = 0; i < whole.pointCount(); ++i) {
    const bool split =
        i > 0 && whole.move[i] == plan::MoveKind::Joint && whole.timeS[i] > whole.timeS[i - 1];
    for (std::size_t k = 1; split && k < pieces; ++k)
      push(i, static_cast<double>(k) / static_cast<double>(pieces));
    push(i, 1.0);
  }
  return t;
}

TEST(SharedRuns, BeadsAreDepositedOnceForDifferentTransfers) {
  const plan::Trajectory pieces = withPieces(detour(), 3);
  ASSERT_GT(pieces.pointCount(), detour().pointCount());
  const ProgramStageInput in = stageInput(pieces);
  SharedRuns shared;
  const auto native = programStage("urscript", in, {}, &shared);
  const auto foreign = programStage("gcode-extended", in, {}, &shared);
  ASSERT_EQ(shared.runs().size(), 2u);
  EXPECT_NE(shared.runs()[0].run.path.motionCount(), shared.runs()[1].run.path.motionCount())
      << "urscript says a transfer's pieces as one";
  EXPECT_EQ(shared.runs()[0].deposited, shared.runs()[1].deposited);
  EXPECT_EQ(native->verdict.collisions, foreign->verdict.collisions);
  EXPECT_DOUBLE_EQ(native->verdict.coveredFraction, foreign->verdict.coveredFraction);
}

// An event that the dialect has no word for blocks the plan by a finding.
TEST(ProgramStage, RefusesAnEventWithoutAWord) {
  plan::Trajectory released = scene().trajectory;
  released.events = {{.point = 2, .kind = plan::EventKind::Release}};
  const auto checked = programStage("gcode-extended", stageInput(released), {});
  EXPECT_FALSE(checked->verdict.passed);
  EXPECT_TRUE(checked->program.files.empty());
  EXPECT_EQ(linesOfPoints(*checked, released).size(), released.pointCount());
  project::Report report;
  plan::Findings findings;
  reportProgram(*checked, true, true, report, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings.front().kind, plan::FindingKind::FormatRefused);
  EXPECT_TRUE(findings.front().blocking);
  // There is no finding before this one: it has its own remedy.
  EXPECT_FALSE(plan::englishRemedy(findings.front()).empty());
  EXPECT_EQ(plan::englishRemedy(findings.front()).find("before this one"), std::string::npos);
  EXPECT_GT(report.replay.thresholds.covered, 0.0);
  PlanResult result;
  result.checked = {checked};
  EXPECT_TRUE(chosenPrograms(result, {"gcode-extended"}, true).empty());
}

// Only a remedy of a finding that follows others may refer to them.
TEST(ProgramStage, ARemedyRefersOnlyToFindingsThatExist) {
  CheckedProgram checked;
  checked.program.format = "urscript-stream";
  checked.failed = {"massRatio 0.5"_text};
  constexpr const char* kLone =
      "change parameters, process or cell of the plan, or leave this format out";
  const auto remedy = [&] {
    project::Report report;
    plan::Findings findings;
    reportProgram(checked, true, true, report, findings);
    EXPECT_EQ(findings.size(), checked.findings.size() + 1);
    EXPECT_TRUE(findings.back().blocking);
    return plan::englishRemedy(findings.back());
  };
  EXPECT_EQ(remedy(), kLone);
  checked.findings = {plan::makeFinding(
      plan::FindingKind::BondTime,
      {{"time", base::seconds(9.0)}, {"limit", base::seconds(5.0)}, {"length", base::mm(20.0)}})};
  EXPECT_EQ(remedy(), kLone);
  checked.findings = {
      plan::makeFinding(plan::FindingKind::PathDeviation, {{"distance", base::mm(1.0)}})};
  EXPECT_EQ(remedy(), "see the findings before this one");
}

} // namespace
} // namespace voluta::pipeline
