// Events of layers in programs of every dialect: pauses with their texts, waits, outputs, and the
// user's own statements are read back and replayed; each is refused if it is deleted, doubled,
// moved or changed.
#include "base/error.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/own_lines.h"
#include "replay/changer_cell.h"
#include "replay/event_programs.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace voluta::replay {
namespace {

using plan::EventKind, plan::TrajectoryEvent;

// A box of four layers. The event is behind the lift from the second layer.
class LayerEventPrograms : public EventPrograms {
protected:
  void SetUp() override { placeEvent(); }
  void placeEvent() {
    const plan::Trajectory& t = scene_.trajectory;
    point_ = 0;
    std::size_t travels = 0;
    for (std::size_t i = 1; i + 1 < t.pointCount() && point_ == 0; ++i)
      if (t.move[i] == plan::MoveKind::Print && t.move[i + 1] != plan::MoveKind::Print &&
          ++travels == 2)
        point_ = i + 2;
    ASSERT_GT(point_, 0u);
  }
  // One of each kind, with another value beside it.
  static std::vector<std::pair<TrajectoryEvent, TrajectoryEvent>> eventsFor(std::string_view id) {
    const std::string format(id);
    const int output = program::outputWords(id).first + 3;
    return {
        {{.kind = EventKind::Pause, .text = "Paused before layer 3 of 4 (z 5.50 mm)"},
         {.kind = EventKind::Pause, .text = "Paused before layer 4 of 4 (z 5.50 mm)"}},
        {{.kind = EventKind::Wait, .seconds = 60.0}, {.kind = EventKind::Wait, .seconds = 50.0}},
        {{.kind = EventKind::Output, .tool = output, .on = true},
         {.kind = EventKind::Output, .tool = output, .on = false}},
        {{.kind = EventKind::Output, .tool = output, .on = false},
         {.kind = EventKind::Output, .tool = output + 1, .on = false}},
        {{.kind = EventKind::Statement, .text = "own_call(1)", .format = format},
         {.kind = EventKind::Statement, .text = "own_call(2)", .format = format}}};
  }
  std::vector<std::string> linesWith(std::string_view format, std::vector<TrajectoryEvent> events) {
    for (TrajectoryEvent& event : events)
      event.point = point_;
    scene_.trajectory.events = std::move(events);
    return test::textOf(programFor(format)).lines;
  }
  // The lines of the event: first, and the one behind the last.
  std::pair<std::size_t, std::size_t>
  blockOf(std::string_view format, const std::vector<std::string>& lines, EventKind kind) const {
    const plan::ReadProgram program = read({std::string(format), "box", lines});
    std::size_t end = 0; // the line, from 1
    for (const plan::StatedFact& fact : program.facts)
      if (kind != EventKind::Wait && fact.before > program.firstMotion &&
          (fact.kind == plan::FactKind::OperatorStop || fact.kind == plan::FactKind::OwnStatement))
        end = fact.line;
    for (const plan::ProgramPause& pause : program.pauses)
      if (kind == EventKind::Wait && pause.durationS > 10.0)
        end = pause.line;
    if (end == 0 || kind == EventKind::Wait)
      return {end - 1, end};
    if (kind != EventKind::Pause)
      return {end - 2, end}; // with its mark
    std::size_t first = end - 1;
    while (lines[first].find("Paused before") == std::string::npos)
      --first;
    // MELFA opens a screen first.
    return {lines[first - 1].find("Open ") == std::string::npos ? first : first - 1, end};
  }
  static std::vector<std::string_view> formats() { return formatsWith(EventKind::Output); }

  Verification verified(std::string_view format, const std::vector<std::string>& lines) const {
    test::ProgramText text{std::string(format), "box", lines};
    return verify(read(text));
  }

  std::size_t point_ = 0;
};

TEST_F(LayerEventPrograms, AreReadBackAndReplayedInEveryDialect) {
  EXPECT_GE(formats().size(), 7u);
  for (const std::string_view format : formats())
    for (const auto& [event, other] : eventsFor(format)) {
      SCOPED_TRACE(std::string(format) + ": " + std::string(program::nameOf(event.kind).english()));
      const std::vector<std::string> lines = linesWith(format, {event});
      const plan::ReadProgram program = read({std::string(format), "box", lines});
      EXPECT_TRUE(program.defects.empty())
          << (program.defects.empty() ? "" : base::english(program.defects[0].reason));
      const Verification v = verify(program);
      EXPECT_TRUE(v.passed) << findingsText(v);
      // Nothing judges what the user's own statement does.
      EXPECT_EQ(
          std::ranges::count(v.findings, plan::FindingKind::OwnStatement, &plan::Finding::kind),
          event.kind == EventKind::Statement ? 1 : 0);
    }
}

TEST_F(LayerEventPrograms, EveryDamageIsRefused) {
  for (const std::string_view format : formats()) {
    for (const auto& [event, other] : eventsFor(format)) {
      SCOPED_TRACE(std::string(format) + ": " + std::string(program::nameOf(event.kind).english()));
      const std::vector<std::string> changed = linesWith(format, {other});
      const std::vector<std::string> whole = linesWith(format, {event});
      const auto [first, end] = blockOf(format, whole, event.kind);
      ASSERT_LT(first, end);
      const auto at = [](std::size_t line) { return static_cast<std::ptrdiff_t>(line); };
      const std::vector<std::string> block(whole.begin() + at(first), whole.begin() + at(end));
      const auto deleted = [&] {
        std::vector<std::string> lines = whole;
        lines.erase(lines.begin() + at(first), lines.begin() + at(end));
        return lines;
      };
      EXPECT_FALSE(verified(format, deleted()).passed) << "deleted";
      std::vector<std::string> doubled = whole;
      doubled.insert(doubled.begin() + at(end), block.begin(), block.end());
      EXPECT_FALSE(verified(format, doubled).passed) << "doubled";
      EXPECT_FALSE(verified(format, changed).passed) << "changed";
      // The same along the way, and a layer later.
      const std::vector<std::string> others = deleted();
      const plan::ReadProgram program = read({std::string(format), "box", others});
      std::size_t next = 0;
      while (next < program.motions.size() && program.motions[next].line <= first)
        ++next;
      std::size_t later = next;
      while (later < program.motions.size() &&
             (program.motions[later].extruding || later < next + 3))
        ++later;
      while (later < program.motions.size() && !program.motions[later].extruding)
        ++later;
      ASSERT_LT(later, program.motions.size());
      ASSERT_GT(next, 1u);
      for (const std::size_t motion : {next - 2, next - 1, next, next + 1, later}) {
        std::vector<std::string> moved = others;
        moved.insert(moved.begin() + at(program.motions[motion].line), block.begin(), block.end());
        if (motion == next - 1)
          continue; // where it was
        EXPECT_FALSE(verified(format, moved).passed) << "moved behind motion " << motion;
      }
    }
  }
}

// Returns whether a statement is missing or another one than planned.
bool isToldOf(const Verification& v) {
  return std::ranges::any_of(v.findings, [](const plan::Finding& finding) {
    return finding.kind == plan::FindingKind::StatementChanged ||
           finding.kind == plan::FindingKind::StatementMissing;
  });
}

// On the way to a point, a language without joint motions has several motions.
TEST_F(LayerEventPrograms, APauseAlongAJointMotionIsRefused) {
  plan::Trajectory& t = scene_.trajectory;
  t.move[point_] = plan::MoveKind::Joint;
  for (const std::string_view format : {"gcode-extended", "urscript"}) {
    SCOPED_TRACE(format);
    linesWith(format, {{.kind = EventKind::Pause, .text = "Layer 3"}});
    plan::ReadProgram whole = read(test::textOf(programFor(format)));
    EXPECT_FALSE(isToldOf(verify(whole))) << findingsText(verify(whole));
    std::size_t stop = 0;
    while (whole.facts[stop].kind != plan::FactKind::OperatorStop ||
           whole.facts[stop].before <= whole.firstMotion)
      ++stop;
    for (const int step : {-1, 1}) {
      plan::ReadProgram moved = whole;
      moved.facts[stop].before += static_cast<std::size_t>(step);
      EXPECT_TRUE(isToldOf(verify(moved))) << step;
    }
  }
}

// What primes the nozzle again would drip off while the operator is awaited.
TEST_F(LayerEventPrograms, APrimeBeforeThePauseIsRefused) {
  test::moveSideways(scene_.trajectory, scene_.cell, point_ - 1);
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    linesWith(format, {{.kind = EventKind::Pause, .text = "Layer 3"},
                       {.kind = EventKind::Purge, .seconds = 4.0, .volumeMm3 = 50.0}});
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    ASSERT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    plan::ReadProgram early = whole;
    for (plan::StatedFact& fact : early.facts)
      if (fact.kind == plan::FactKind::OperatorStop && fact.before > early.firstMotion)
        fact.beforePause = early.pauses.size();
    EXPECT_FALSE(verify(early).passed);
  }
}

// A pause and the change of a feeder fall on one point where nothing can be purged beside the part.
TEST_F(LayerEventPrograms, APauseMayPrecedeAChangeThatNeedsNoOperator) {
  process::Process other = scene_.process;
  other.id = "other";
  tooling_ = process::Tooling({{scene_.process}, {other}});
  const plan::Trajectory& t = scene_.trajectory;
  for (plan::ToolPath& path : scene_.plan.paths)
    path.tool = path.first >= t.waypoint[point_ + 1] ? 1 : 0;
  std::size_t refused = 0;
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    linesWith(format, {{.kind = EventKind::Pause, .text = "Put in the nut"},
                       {.kind = EventKind::ToolChange, .tool = 1}});
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    const Verification v = verify(whole);
    EXPECT_FALSE(isToldOf(v)) << findingsText(v);
    // The stop behind the change, as programs were written before.
    scene_.trajectory.events = {scene_.trajectory.events[1], scene_.trajectory.events[0]};
    const Verification reversed = verify(read(test::textOf(programFor(format))));
    refused += isToldOf(reversed) ? 1U : 0U;
  }
  EXPECT_EQ(refused, formats().size());
}

TEST_F(LayerEventPrograms, AFormatRefusesWhatItCannotSay) {
  const auto reasonOf = [&](std::string_view format, TrajectoryEvent event) {
    try {
      linesWith(format, {std::move(event)});
    } catch (const base::Error& error) {
      return base::english(error.whole());
    }
    return std::string();
  };
  EXPECT_NE(reasonOf("csv", {.kind = EventKind::Output, .tool = 3}).find("setting an output"),
            std::string::npos);
  EXPECT_NE(reasonOf("rapid", {.kind = EventKind::Statement, .text = "foo()", .format = "urscript"})
                .find("is one of format urscript"),
            std::string::npos);
  EXPECT_NE(reasonOf("urscript", {.kind = EventKind::Output, .tool = 8}).find("outputs 0 to 7"),
            std::string::npos);
  for (const std::string_view format : {"urscript", "krl", "tmscript"}) {
    const int own = program::outputWords(format).first; // the extruder's
    EXPECT_NE(reasonOf(format, {.kind = EventKind::Output, .tool = own, .on = true})
                  .find("is used by the program itself"),
              std::string::npos)
        << format;
  }
}

} // namespace
} // namespace voluta::replay
