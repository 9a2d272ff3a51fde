// Planned pauses in programs: a missing one, an added one and a moved one are each refused at
// their line.
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/scene.h"
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
    text_ = test::textOf(program::writeProgram(
        "urscript", {scene_.plan, scene_.trajectory, scene_.cell, scene_.process, "box"}));
    const auto line = std::ranges::find_if(
        text_.lines, [](const std::string& l) { return l.starts_with(kPause); });
    ASSERT_NE(line, text_.lines.end());
    pause_ = static_cast<std::size_t>(line - text_.lines.begin());
  }
  Verification verify() const {
    return replayProgram({test::read(text_, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, scene_.process, scene_.part, scene_.platform},
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
  EXPECT_TRUE(v.passed) << told(v);
}

TEST_F(PlannedEvents, AMissingOneIsFound) {
  text_.lines.erase(text_.lines.begin() + static_cast<std::ptrdiff_t>(pause_));
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::StatementMissing;
  })) << told(v);
}

TEST_F(PlannedEvents, AnAddedOneIsFoundAtItsLine) {
  const std::string line = text_.lines[pause_];
  // Before the next travel's end: the extruder is off there too.
  text_.lines.insert(text_.lines.begin() + static_cast<std::ptrdiff_t>(pause_) + 2, line);
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(isFound(v, plan::FindingKind::StatementChanged, pause_ + 3)) << told(v);
}

TEST_F(PlannedEvents, ATrajectoryWithoutEventsTakesNoPause) {
  scene_.trajectory.events.clear();
  const Verification v = verify();
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(isFound(v, plan::FindingKind::StatementChanged, pause_ + 1)) << told(v);
}

} // namespace
} // namespace voluta::replay
