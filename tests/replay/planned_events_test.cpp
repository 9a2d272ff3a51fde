// Planned pauses in programs: a missing one, an added one and a moved one are each refused at
// their line.
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "program/dialect.h"
#include "program/job_head.h"
#include "program/text_damage.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

constexpr const char* kPause = "  popup(\"Paused. Continue?\"";

class PlannedEvents : public ::testing::Test {
protected:
  void SetUp() override {
    // Behind the lift at the end of the first path.
    std::size_t point = 1;
    while (scene_.trajectory.move[point] != plan::MoveKind::Print)
      ++point;
    while (scene_.trajectory.move[point] == plan::MoveKind::Print)
      ++point;
    scene_.trajectory.events = {{.point = point + 1, .kind = plan::EventKind::Pause}};
    text_ =
        test::textOf(program::writeProgram("urscript", {scene_.plan, scene_.trajectory, scene_.cell,
                                                        process::Tooling(scene_.process), "box"}));
    const auto line = std::ranges::find_if(
        text_.lines, [](const std::string& l) { return l.starts_with(kPause); });
    ASSERT_NE(line, text_.lines.end());
    pause_ = static_cast<std::size_t>(line - text_.lines.begin());
  }
  Verification verify() const {
    return replayProgram({test::read(text_, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, process::Tooling(scene_.process), scene_.part,
                          scene_.platform},
                         ReplayThresholds{}, {});
  }
  // Line: 1-based.
  static bool isFound(const Verification& v, plan::FindingKind kind, std::size_t line) {
    for (std::size_t i = 0; i < v.findings.size(); ++i)
      if (v.findings[i].kind == kind && v.places[i].line == line)
        return true;
    return false;
  }

  test::Scene scene_ = test::boxScene();
  test::ProgramText text_;
  std::size_t pause_ = 0; // its line, from 0
};

TEST_F(PlannedEvents, AreFoundWhereTheyWerePlanned) {
  const Verification v = verify();
  EXPECT_TRUE(v.passed) << findingsText(v);
}

TEST_F(PlannedEvents, AMissingOneIsFound) {
  text_.lines.erase(text_.lines.begin() + static_cast<std::ptrdiff_t>(pause_));
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::StatementMissing;
  })) << findingsText(v);
}

TEST_F(PlannedEvents, AnAddedOneIsFoundAtItsLine) {
  const std::string line = text_.lines[pause_];
  // Before the next travel's end: the extruder is off there too.
  text_.lines.insert(text_.lines.begin() + static_cast<std::ptrdiff_t>(pause_) + 2, line);
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(isFound(v, plan::FindingKind::StatementChanged, pause_ + 3)) << findingsText(v);
}

TEST_F(PlannedEvents, ATrajectoryWithoutEventsTakesNoPause) {
  scene_.trajectory.events.clear();
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(isFound(v, plan::FindingKind::StatementChanged, pause_ + 1)) << findingsText(v);
}

// Before the first motion, only the last selection counts.
TEST_F(PlannedEvents, AToolSelectedAtTheStartIsFound) {
  const process::Tooling two({{scene_.process}, {scene_.process}});
  const auto replayed = [&](const std::vector<int>& tools) {
    plan::ReadProgram program = test::read(text_, scene_.process);
    for (plan::StatedFact& fact : program.facts)
      if (fact.kind == plan::FactKind::OperatorStop && fact.before <= program.firstMotion)
        fact.word = program::toolName(two, 0); // A program of one tool names none.
    for (const int tool : tools)
      program.facts.push_back(
          {.kind = plan::FactKind::ToolSelected, .line = 7, .word = {}, .tool = tool});
    return replayProgram({std::move(program), scene_.plan, scene_.trajectory, scene_.cell, two,
                          scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  };
  const Verification v = replayed({1});
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(isFound(v, plan::FindingKind::StatementChanged, 7)) << findingsText(v);
  EXPECT_TRUE(replayed({0}).passed) << findingsText(replayed({0}));
  EXPECT_TRUE(replayed({1, 0}).passed);
}

// The flow of a motion is checked against the limit of the tool that its text has selected.
TEST_F(PlannedEvents, EachToolHasItsOwnFlow) {
  process::Tool narrow{scene_.process};
  narrow.process.maxFlowMm3PerS *= 0.01;
  plan::ReadProgram program = test::read(text_, scene_.process);
  const auto limited = [&](const process::Tooling& tooling) {
    return replayProgram({program, scene_.plan, scene_.trajectory, scene_.cell, tooling,
                          scene_.part, scene_.platform},
                         ReplayThresholds{}, {})
        .limitViolations;
  };
  const process::Tooling tools({{scene_.process}, narrow});
  EXPECT_EQ(limited(tools), 0u);
  for (plan::ProgramMotion& motion : program.motions)
    motion.tool = 1;
  EXPECT_GT(limited(tools), 0u);
}

// A path of the box as tape, which is cut 10 mm before its end.
class PlannedCuts : public ::testing::Test {
protected:
  void SetUp() override {
    plan::Trajectory& t = scene_.trajectory;
    plan::ToolPath& path = scene_.plan.paths.at(scene_.plan.paths.size() / 2);
    path.kind = plan::PathKind::Tape;
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w)
      planned_ += process::beadVolume(
          areaAt(w - 1), areaAt(w), (scene_.plan.position[w] - scene_.plan.position[w - 1]).norm());
    std::size_t point = 0;
    while (t.waypoint[point] != path.first + path.count / 2)
      ++point;
    ASSERT_EQ(t.move[point + 1], plan::MoveKind::Print);
    t.events = {{.point = point + 1, .kind = plan::EventKind::Cut}};
  }
  double areaAt(std::size_t w) const {
    return process::beadArea(scene_.plan.widthMm[w], scene_.plan.heightMm[w]);
  }
  test::ProgramText textOf(const char* dialect) const {
    return test::textOf(program::writeProgram(dialect, {scene_.plan, scene_.trajectory, scene_.cell,
                                                        process::Tooling(scene_.process), "box"}));
  }
  Verification verify(const test::ProgramText& text) const {
    return replayProgram({test::read(text, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, process::Tooling(scene_.process), scene_.part,
                          scene_.platform},
                         ReplayThresholds{}, {});
  }
  static std::size_t events(const Verification& v) {
    return static_cast<std::size_t>(std::ranges::count_if(v.findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::StatementMissing ||
             f.kind == plan::FindingKind::StatementChanged;
    }));
  }

  test::Scene scene_ = test::boxScene();
  double planned_ = 0.0; // [mm3]
};

TEST_F(PlannedCuts, AreFoundAndTapeIsCountedApart) {
  const Verification v = verify(textOf("urscript"));
  EXPECT_EQ(events(v), 0u) << findingsText(v);
  EXPECT_EQ(v.deviations, 0u) << findingsText(v);
  EXPECT_NEAR(v.tapeMm3, planned_, 0.002 * planned_);
  EXPECT_EQ(v.supportMm3, 0.0);
}

TEST_F(PlannedCuts, AMissingOrMovedOneIsRefused) {
  constexpr const char* kCut = "  set_standard_digital_out(7,True)";
  const test::ProgramText text = textOf("urscript");
  const auto cut = std::ranges::find_if(
      text.lines, [](const std::string& line) { return line.starts_with(kCut); });
  ASSERT_NE(cut, text.lines.end());
  const auto at = cut - text.lines.begin();

  test::ProgramText missing = text;
  missing.lines.erase(missing.lines.begin() + at);
  EXPECT_FALSE(verify(missing).passed);
  EXPECT_EQ(events(verify(missing)), 1u);

  for (const int by : {-3, 3}) {
    test::ProgramText moved = missing;
    const auto moves = [&](const std::string& line) { return line.starts_with("  movel("); };
    auto to = at;
    for (int left = std::abs(by); left > 0; to += by > 0 ? 1 : -1)
      left -= moves(moved.lines[static_cast<std::size_t>(to)]) ? 1 : 0;
    moved.lines.insert(moved.lines.begin() + to, *cut);
    const Verification v = verify(moved);
    EXPECT_FALSE(v.passed) << by;
    EXPECT_EQ(events(v), 2u) << "missing there, not planned here: " << by;
  }
  test::ProgramText twice = text;
  twice.lines.insert(twice.lines.begin() + at, *cut);
  EXPECT_EQ(events(verify(twice)), 1u);
}

} // namespace
} // namespace voluta::replay
