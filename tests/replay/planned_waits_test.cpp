// Planned waits in programs of every dialect: a deleted, a shorter, a longer and an added one are
// refused, and the replay's clock counts them between a bead and the bead that covers it.
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

constexpr double kWaitS = 23.456;

class PlannedWaits : public ::testing::Test {
protected:
  // Before the first bead of each layer but the first, behind the lift.
  void SetUp() override {
    plan::Trajectory& t = scene_.trajectory;
    int layer = 0;
    for (std::size_t i = 1; i + 1 < t.pointCount(); ++i) {
      if (t.move[i] == plan::MoveKind::Print || t.move[i + 1] != plan::MoveKind::Print)
        continue;
      const plan::ToolPath* path = plan::pathOf(scene_.plan, t.waypoint[i]);
      if (path->layer == layer)
        continue;
      layer = path->layer;
      t.events.push_back({.point = i, .kind = plan::EventKind::Wait, .seconds = kWaitS});
    }
    ASSERT_EQ(t.events.size(), 3u);
  }
  static bool says(const program::Dialect& dialect) {
    return std::ranges::find(dialect.events, plan::EventKind::Wait) != dialect.events.end() &&
           dialect.tiltsNozzle;
  }
  test::ProgramText textFor(const program::Dialect& dialect) const {
    return test::textOf(
        program::writeProgram(dialect.id, {scene_.plan, scene_.trajectory, scene_.cell,
                                           process::Tooling(scene_.process), "box"}));
  }
  Verification verify(const plan::ReadProgram& program, double minS = 0.0) const {
    ReplayInput input{program,
                      scene_.plan,
                      scene_.trajectory,
                      scene_.cell,
                      process::Tooling(scene_.process),
                      scene_.part,
                      scene_.platform};
    input.layerTimes.minS = minS;
    return replayProgram(std::move(input), ReplayThresholds{}, {});
  }
  Verification verify(const test::ProgramText& text, double minS = 0.0) const {
    return verify(test::read(text, scene_.process), minS);
  }

  test::Scene scene_ = test::boxScene();
};

TEST_F(PlannedWaits, AreReadBackByEveryDialect) {
  std::size_t dialects = 0;
  for (const program::Dialect& dialect : test::dialectsFor("urscript")) {
    if (!says(dialect))
      continue;
    SCOPED_TRACE(dialect.id);
    ++dialects;
    const plan::ReadProgram read = test::read(textFor(dialect), scene_.process);
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    EXPECT_EQ(std::ranges::count_if(read.pauses,
                                    [](const plan::ProgramPause& p) {
                                      return std::abs(p.durationS - kWaitS) < 1e-3;
                                    }),
              3);
  }
  EXPECT_GE(dialects, 8u);
}

TEST_F(PlannedWaits, TheClockCountsThem) {
  const test::ProgramText text = textFor(program::findDialect("urscript"));
  const Verification v = verify(text, kWaitS);
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_GE(v.layerTimes.shortestS, kWaitS);
  EXPECT_FALSE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::CoolingTime;
  })) << findingsText(v);
  plan::ReadProgram read = test::read(text, scene_.process);
  double waits = 0.0;
  std::erase_if(read.pauses, [&](const plan::ProgramPause& p) {
    waits += p.durationS > 1.0 ? p.durationS : 0.0;
    return p.durationS > 1.0;
  });
  const Verification hasty = verify(read, kWaitS);
  EXPECT_NEAR(v.durationS - hasty.durationS, waits, 1e-6);
  EXPECT_NEAR(waits, 3.0 * kWaitS, 1e-6);
  EXPECT_LT(hasty.layerTimes.shortestS, kWaitS);
  EXPECT_TRUE(std::ranges::any_of(hasty.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::CoolingTime;
  })) << findingsText(hasty);
}

TEST_F(PlannedWaits, OldNeighboursGiveAFinding) {
  ReplayInput input{test::read(textFor(program::findDialect("urscript")), scene_.process),
                    scene_.plan,
                    scene_.trajectory,
                    scene_.cell,
                    process::Tooling(scene_.process),
                    scene_.part,
                    scene_.platform};
  input.layerTimes.maxS = kWaitS;
  const Verification v = replayProgram(std::move(input), ReplayThresholds{}, {});
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::BondTime && !f.blocking && f.where;
  })) << findingsText(v);
}

// Forty edits: a wait deleted, shortened, lengthened or doubled, in a dialect chosen at random.
TEST_F(PlannedWaits, EveryEditIsRefused) {
  std::vector<plan::ReadProgram> programs;
  for (const program::Dialect& dialect : test::dialectsFor("urscript"))
    if (says(dialect))
      programs.push_back(test::read(textFor(dialect), scene_.process));
  std::mt19937 random(41);
  for (int edit = 0; edit < 40; ++edit) {
    plan::ReadProgram program = programs[random() % programs.size()];
    std::vector<std::size_t> waits;
    for (std::size_t p = 0; p < program.pauses.size(); ++p)
      if (std::abs(program.pauses[p].durationS - kWaitS) < 1e-3)
        waits.push_back(p);
    ASSERT_EQ(waits.size(), 3u);
    const auto at =
        program.pauses.begin() + static_cast<std::ptrdiff_t>(waits[random() % waits.size()]);
    const auto kind = static_cast<int>(random() % 4);
    const double share = 0.05 + 0.9 * static_cast<double>(random() % 1000) / 1000.0;
    SCOPED_TRACE(program.format + " edit " + std::to_string(kind));
    if (kind == 0)
      program.pauses.erase(at);
    else if (kind == 1)
      at->durationS *= share;
    else if (kind == 2)
      at->durationS *= 1.05 + share;
    else
      program.pauses.insert(at, plan::ProgramPause(*at));
    const Verification v = verify(program);
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::StatementMissing ||
             f.kind == plan::FindingKind::StatementChanged;
    })) << findingsText(v);
  }
}

} // namespace
} // namespace voluta::replay
