// A program that prints the beads of one judged before shares them; any other does not.
#include "base/run_context.h"
#include "pipeline/outputs.h"
#include "pipeline/replay_stage.h"
#include "pipeline/replayed/shared_runs.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/scene.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

plan::ReadProgram boxProgram() {
  const test::Scene& s = scene();
  const plan::Program written = program::writeProgram(
      "gcode-extended", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  return program::readProgram("gcode-extended", written.files, process::Tooling(s.process));
}

// Does a program share the beads of boxProgram after this change?
bool shares(const std::function<void(plan::ReadProgram&)>& change) {
  const test::Scene& s = scene();
  SharedRuns shared;
  for (const bool changed : {false, true}) {
    plan::ReadProgram program = boxProgram();
    if (changed)
      change(program);
    replayShared(
        {program, s.plan, s.trajectory, s.cell, process::Tooling(s.process), s.part, s.platform},
        shared, {});
  }
  return shared.runs().size() == 2 && shared.runs()[0].laid == shared.runs()[1].laid;
}

// The motion in the middle of those that do, or do not, lay something.
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

} // namespace

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

// An event that the dialect has no word for blocks the plan by a finding.
TEST(ProgramStage, RefusesAnEventWithoutAWord) {
  const test::Scene& s = scene();
  plan::Trajectory released = s.trajectory;
  released.events = {{.point = 2, .kind = plan::EventKind::Release}};
  const ProgramStageInput in{
      s.part, s.platform, s.plan, released, s.cell, process::Tooling(s.process), "box"};
  const auto checked = programStage("gcode-extended", in, {});
  EXPECT_FALSE(checked->passed);
  EXPECT_TRUE(checked->program.files.empty());
  EXPECT_EQ(linesOfPoints(*checked, released).size(), released.pointCount());
  project::Report report;
  plan::Findings findings;
  tellProgram(*checked, true, true, report, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings.front().kind, plan::FindingKind::ProgramRefused);
  EXPECT_TRUE(findings.front().blocking);
  EXPECT_GT(report.replay.thresholds.covered, 0.0);
  PlanResult result;
  result.checked = {checked};
  EXPECT_TRUE(chosenPrograms(result, {"gcode-extended"}, true).empty());
}

} // namespace voluta::pipeline
