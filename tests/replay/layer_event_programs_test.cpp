// Events of layers in programs of every dialect: pauses with their texts, waits, outputs, and the
// user's own statements are read back and replayed; each is refused if it is deleted, doubled,
// moved or changed.
#include "base/error.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/own_lines.h"
#include "replay/changer_cell.h"
#include "replay/event_programs.h"
#include "replay/planned_events.h"
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
          fact.before < program.motions.size() &&
          (fact.kind == plan::FactKind::OperatorStop || fact.kind == plan::FactKind::OwnStatement))
        end = fact.line;
    for (const plan::ProgramPause& pause : program.pauses)
      if (kind == EventKind::Wait && pause.durationS > 10.0)
        end = pause.line;
    if (end == 0 || kind == EventKind::Wait)
      return {end - 1, end};
    if (kind != EventKind::Pause)
      // With its mark, and the line that waits for the arm.
      return {end - (program::outputWords(format).settles.empty() ? 2 : 3), end};
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

// With the output on, the operator would reach in.
TEST_F(LayerEventPrograms, NeighboursInAnotherOrderAreRefused) {
  test::moveSideways(scene_.trajectory, scene_.cell, point_ - 1);
  for (const std::string_view format : formats()) {
    const std::string id(format);
    const int output = program::outputWords(format).first + 3;
    const std::vector<TrajectoryEvent> kinds = {
        {.kind = EventKind::Output, .tool = output, .on = false},
        {.kind = EventKind::Statement, .text = "own_call(1)", .format = id},
        {.kind = EventKind::Pause, .text = "Put in the nut"},
        {.kind = EventKind::Wait, .seconds = 60.0},
        {.kind = EventKind::Purge, .seconds = 4.0, .volumeMm3 = 50.0}};
    for (std::size_t a = 0; a < kinds.size(); ++a)
      for (std::size_t b = 0; b < kinds.size(); ++b) {
        // The nozzle is filled again behind the pause.
        if (a == b || (kinds[a].kind == EventKind::Purge && kinds[b].kind == EventKind::Pause))
          continue;
        SCOPED_TRACE(id + ": " + std::string(program::nameOf(kinds[a].kind).english()) + ", " +
                     std::string(program::nameOf(kinds[b].kind).english()));
        linesWith(format, {kinds[a], kinds[b]});
        const plan::ReadProgram whole = read(test::textOf(programFor(format)));
        EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
        std::swap(scene_.trajectory.events[0], scene_.trajectory.events[1]);
        EXPECT_FALSE(verify(whole).passed);
      }
  }
}

// Controllers take the line while motions are queued, unless a line before makes them wait.
TEST_F(LayerEventPrograms, ALineAheadOfTheArmIsRefused) {
  std::size_t settled = 0;
  for (const std::string_view format : formats())
    for (const auto& [event, other] : eventsFor(format)) {
      const std::string_view settles = program::outputWords(format).settles;
      if (settles.empty() || event.kind == EventKind::Pause || event.kind == EventKind::Wait)
        continue;
      SCOPED_TRACE(std::string(format) + ": " + std::string(program::nameOf(event.kind).english()));
      std::vector<std::string> lines = linesWith(format, {event});
      const auto mark = std::ranges::find_if(lines, [](const std::string& line) {
        return line.find(program::kOwnLineMark) != std::string::npos;
      });
      ASSERT_NE(mark, lines.end());
      ASSERT_NE((mark - 1)->find(settles), std::string::npos) << *(mark - 1);
      lines.erase(mark - 1);
      const plan::ReadProgram program = read({std::string(format), "box", lines});
      EXPECT_TRUE(std::ranges::any_of(program.defects, [](const plan::ProgramDefect& defect) {
        return base::english(defect.reason).find("ahead of the arm") != std::string::npos;
      }));
      EXPECT_FALSE(verify(program).passed);
      ++settled;
    }
  EXPECT_EQ(settled, 9u) << "extended G-code, KRL and TMscript, each with three lines";
}

// Whatever ran before may have left the outputs in any state.
TEST_F(LayerEventPrograms, OutputsAreOffBeforeAndBehindThePrint) {
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const int output = program::outputWords(format).first + 3;
    const std::vector<std::string> lines =
        linesWith(format, {{.kind = EventKind::Output, .tool = output, .on = true}});
    const plan::ReadProgram whole = read({std::string(format), "box", lines});
    std::vector<const plan::StatedFact*> own;
    for (const plan::StatedFact& fact : whole.facts)
      if (fact.kind == plan::FactKind::OwnStatement)
        own.push_back(&fact);
    ASSERT_EQ(own.size(), 3u);
    EXPECT_LE(own[0]->before, whole.firstMotion);
    EXPECT_EQ(own[2]->before, whole.motions.size());
    EXPECT_EQ(own[0]->word, own[2]->word);
    EXPECT_NE(own[0]->word, own[1]->word);
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    for (std::size_t k = 0; k < whole.facts.size(); ++k) {
      if (whole.facts[k].kind != plan::FactKind::OwnStatement)
        continue;
      plan::ReadProgram changed = whole;
      changed.facts.erase(changed.facts.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_TRUE(isToldOf(verify(changed))) << "deleted";
      changed = whole;
      changed.facts.insert(changed.facts.begin() + static_cast<std::ptrdiff_t>(k), whole.facts[k]);
      EXPECT_TRUE(isToldOf(verify(changed))) << "doubled";
      changed = whole;
      changed.facts[k].word = whole.facts[k].word == own[0]->word ? own[1]->word : own[0]->word;
      EXPECT_TRUE(isToldOf(verify(changed))) << "changed";
    }
  }
}

TEST_F(LayerEventPrograms, EachFileSetsTheOutputsAgain) {
  for (const std::string_view format : {"urscript", "krl", "rapid", "spel", "melfa"}) {
    SCOPED_TRACE(format);
    const int output = program::outputWords(format).first + 3;
    linesWith(format, {{.kind = EventKind::Output, .tool = output, .on = true}});
    program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"};
    input.options.motionsPerFile = 25;
    const plan::ReadProgram whole =
        program::readProgram(format, program::writeProgram(format, input).files, tooling_);
    EXPECT_TRUE(whole.defects.empty());
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    std::size_t begins = 0;
    for (std::size_t k = 0; k < whole.facts.size(); ++k) {
      const plan::StatedFact& fact = whole.facts[k];
      const bool isBegin = fact.kind == plan::FactKind::OwnStatement && fact.before > 0 &&
                           fact.before < whole.motions.size() &&
                           whole.motions[fact.before].file != whole.motions[fact.before - 1].file;
      if (!isBegin)
        continue;
      ++begins;
      plan::ReadProgram missing = whole;
      missing.facts.erase(missing.facts.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_TRUE(isToldOf(verify(missing)));
    }
    EXPECT_GE(begins, 3u);
  }
}

// The rest of a print does not run what stands before it.
TEST_F(LayerEventPrograms, AStatementBeforeTheRestIsNamed) {
  linesWith("urscript",
            {{.kind = EventKind::Statement, .text = "own_call(1)", .format = "urscript"}});
  const plan::ReadProgram program = read(test::textOf(programFor("urscript")));
  Alignment alignment;
  alignment.pointOf.assign(program.motions.size(), kUnmatched);
  alignment.leadsTo = alignment.pointOf;
  const auto found = ownStatements(program, scene_.trajectory, alignment, point_);
  ASSERT_GE(found.size(), 1u);
  EXPECT_EQ(found[0].finding.kind, plan::FindingKind::StatementBeforeRest);
  EXPECT_FALSE(found[0].finding.blocking);
  EXPECT_EQ(found[0].finding.program.line, 0u) << "no line of the rest";
  EXPECT_EQ(plan::englishReason(found[0].finding),
            "the rest does not run your statement before its beginning: own_call(1)");
  EXPECT_EQ(std::ranges::count_if(found,
                                  [](const TextFinding& one) {
                                    return one.finding.kind == plan::FindingKind::OwnStatement;
                                  }),
            0);
}

TEST_F(LayerEventPrograms, TheCuttersPinIsTheProgramsOwn) {
  const auto reasonOf = [&](std::vector<TrajectoryEvent> events) {
    try {
      linesWith("gcode-extended", std::move(events));
    } catch (const base::Error& error) {
      return base::english(error.whole());
    }
    return std::string();
  };
  const TrajectoryEvent output{.kind = EventKind::Output, .tool = 1, .on = true};
  EXPECT_EQ(reasonOf({output}), "");
  EXPECT_NE(reasonOf({{.kind = EventKind::Cut}, output}).find("is used by the program itself"),
            std::string::npos);
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
