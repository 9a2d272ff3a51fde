// A replay in two steps, with and without known results.
#include "base/run_context.h"
#include "program/dialect.h"
#include "replay/replay_scene.h"
#include "replay/replay_steps.h"
#include "replay/told.h"

#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

ReplayInput input() {
  const test::Scene& s = scene();
  const plan::Program written = program::writeProgram(
      "urscript", {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  return {program::readProgram("urscript", written.files, process::Tooling(s.process)),
          s.plan,
          s.trajectory,
          s.cell,
          process::Tooling(s.process),
          s.part,
          s.platform};
}

JudgedProgram inSteps(const KnownResults& known) {
  ReplayInput in = input();
  ComparedProgram compared = compareProgram(in, {}, {});
  EXPECT_TRUE(in.program.motions.empty()) << "freed before the beads are deposited";
  return judgeProgram(std::move(compared), in, {}, known, {});
}

// Everything that judging `run` has found.
KnownResults resultsOf(const JudgedRun& run) {
  const std::size_t motions = run.run.path.motionCount();
  return {run.deposited,
          run.figures,
          run.beads,
          firstPieceOfMotions(run.deposited->pieces, motions),
          std::vector<char>(motions, 1),
          std::vector<char>(motions, 1),
          run.head,
          run.arm};
}

void expectSame(const Verification& a, const Verification& b) {
  EXPECT_EQ(findingsText(a), findingsText(b));
  EXPECT_EQ(a.passed, b.passed);
  EXPECT_EQ(a.coveredFraction, b.coveredFraction);
  EXPECT_EQ(a.overfillFraction, b.overfillFraction);
  EXPECT_EQ(a.massRatio, b.massRatio);
  EXPECT_EQ(a.collisions, b.collisions);
  EXPECT_EQ(a.maxDeviationMm, b.maxDeviationMm);
  EXPECT_EQ(a.motionS, b.motionS);
}

TEST(ReplaySteps, AreTheWholeReplayWithNothingKnown) {
  const JudgedProgram judged = inSteps({});
  expectSame(judged.verdict, replayProgram(input(), {}, {}));
  EXPECT_TRUE(judged.verdict.passed) << findingsText(judged.verdict);
}

TEST(ReplaySteps, TakeKnownResultsAsTheyAre) {
  const JudgedProgram first = inSteps({});
  KnownResults known = resultsOf(first.run);
  const JudgedProgram second = inSteps(known);
  EXPECT_EQ(second.run.deposited, first.run.deposited);
  expectSame(second.verdict, first.verdict);

  Clash clash;
  clash.motion = clash.lastMotion = first.run.run.path.motionCount() / 2;
  clash.first = "head"_text;
  clash.second = "platform"_text;
  known.head.push_back(clash);
  const Verification met = inSteps(known).verdict;
  EXPECT_FALSE(met.passed);
  ASSERT_EQ(met.collisions, 1u);
  ASSERT_EQ(met.places.size(), 1u);
  EXPECT_EQ(met.places.front().line, met.motionPlaces[clash.motion].line);
}

// An unknown motion is checked although all others are known.
TEST(ReplaySteps, CheckUnknownMotions) {
  const JudgedProgram first = inSteps({});
  KnownResults known = resultsOf(first.run);
  known.headKnown[known.headKnown.size() / 2] = 0;
  known.armKnown.clear();
  expectSame(inSteps(known).verdict, first.verdict);
}

} // namespace
} // namespace voluta::replay
