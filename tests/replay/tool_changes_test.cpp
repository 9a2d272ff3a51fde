// Tool changes in programs of every dialect that has them: they are read back and replayed, and a
// missing, added or wrong tool, a missing pause, a missing or changed purge, and every other order
// than stop, selection, heat and purge are refused.
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/changer_cell.h"
#include "replay/event_programs.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <random>

namespace voluta::replay {
namespace {

constexpr double kPurgeMm3 = 50.0, kPurgeS = 4.0;

// A box of four layers, the second and the third of them by tool 2.
class ToolChanges : public EventPrograms {
protected:
  void SetUp() override { addChanges(); }
  void addChanges() {
    for (plan::ToolPath& path : scene_.plan.paths)
      path.tool = path.layer == 1 || path.layer == 2 ? 1 : 0;
    process::Process other = scene_.process;
    other.id = "other";
    other.maxFlowMm3PerS *= 1.5;
    other.material.label = "PETG";
    other.material.nozzleC = 235;
    tooling_ = process::Tooling({{scene_.process}, {other}});
    plan::Trajectory& t = scene_.trajectory;
    int tool = 0;
    for (std::size_t i = 1; i + 1 < t.pointCount(); ++i) {
      if (t.move[i] == plan::MoveKind::Print || t.move[i + 1] != plan::MoveKind::Print)
        continue;
      const plan::ToolPath* path = plan::pathOf(scene_.plan, t.waypoint[i]);
      if (std::exchange(tool, path->tool) == path->tool)
        continue;
      test::moveSideways(t, scene_.cell, i - 1);
      t.events.push_back({.point = i, .kind = plan::EventKind::Pause});
      t.events.push_back({.point = i, .kind = plan::EventKind::ToolChange, .tool = tool});
      t.events.push_back(
          {.point = i, .kind = plan::EventKind::Purge, .seconds = kPurgeS, .volumeMm3 = kPurgeMm3});
    }
    ASSERT_EQ(t.events.size(), 6u);
  }
  // A changer switches the tools: no stop, no purge.
  void useChanger() {
    scene_ = test::boxScene(4, test::changerCell());
    addChanges();
    std::vector<plan::TrajectoryEvent> events;
    for (const plan::TrajectoryEvent& event : scene_.trajectory.events)
      if (event.kind == plan::EventKind::ToolChange) {
        events.push_back({.point = event.point, .kind = plan::EventKind::Release, .seconds = 1.0});
        events.push_back(event);
        events.push_back({.point = event.point, .kind = plan::EventKind::Lock, .seconds = 1.0});
      }
    scene_.trajectory.events = events;
  }
  static std::vector<std::string_view> formats() {
    return formatsWith(plan::EventKind::ToolChange);
  }

  // Indices of the facts and of the purge of a change.
  struct Change {
    std::size_t stop = 0, select = 0, purge = 0;
    std::optional<std::size_t> heat;
  };
  static Change changeOf(const plan::ReadProgram& program, int which) {
    Change change;
    for (std::size_t f = 0, stops = 0; f < program.facts.size(); ++f)
      if (program.facts[f].kind == plan::FactKind::OperatorStop &&
          program.facts[f].before > program.firstMotion && stops++ == std::size_t(which))
        change.stop = f;
    const std::size_t motion = program.facts[change.stop].before;
    for (std::size_t f = 0; f < program.facts.size(); ++f)
      if (program.facts[f].before == motion) {
        if (program.facts[f].kind == plan::FactKind::ToolSelected)
          change.select = f;
        if (program.facts[f].kind == plan::FactKind::NozzleHeatWait)
          change.heat = f;
      }
    for (std::size_t p = 0; p < program.pauses.size(); ++p)
      if (program.pauses[p].before == motion && program.pauses[p].volumeMm3 > 1.0)
        change.purge = p;
    return change;
  }
  static void expectAt(const Verification& v, std::size_t line) {
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(
        std::ranges::any_of(v.places, [&](const TextPlace& place) { return place.line == line; }))
        << "nothing is told at line " << line << "\n"
        << findingsText(v);
  }

  // Selects the other tool right after a change.
  static void addOtherTool(plan::ReadProgram& program,
                           std::vector<plan::StatedFact>::const_iterator change) {
    plan::StatedFact other = *change;
    other.tool = 1 - other.tool;
    program.facts.insert(change + 1, std::move(other));
  }
};

TEST_F(ToolChanges, AreReadBackAndReplayedInEveryDialect) {
  EXPECT_GE(formats().size(), 3u);
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const plan::ReadProgram read = this->read(test::textOf(programFor(format)));
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    std::vector<int> selected;
    for (const plan::StatedFact& fact : read.facts)
      if (fact.kind == plan::FactKind::ToolSelected)
        selected.push_back(fact.tool);
    EXPECT_EQ(selected, (std::vector<int>{0, 1, 0}));
    EXPECT_EQ(std::ranges::count_if(read.pauses,
                                    [](const plan::ProgramPause& p) {
                                      return std::abs(p.volumeMm3 - kPurgeMm3) < 0.2;
                                    }),
              2);
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    EXPECT_NEAR(v.massRatio, 1.0, 0.02);
  }
}

// The arm would select, heat and purge while the operator's hands are at the nozzle.
TEST_F(ToolChanges, AStopThatEndsByItselfIsRefused) {
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    plan::ReadProgram read = this->read(test::textOf(programFor(format)));
    plan::StatedFact& stop = read.facts[changeOf(read, 1).stop];
    ASSERT_GT(stop.number, 0.0);
    stop.number = 0.0;
    expectAt(verify(read), stop.line);
  }
  test::ProgramText text = test::textOf(programFor("urscript"));
  std::size_t changed = 0;
  for (std::string& line : text.lines)
    if (line.find("Fit tool 1") != std::string::npos)
      if (const std::size_t at = line.find("blocking=True"); at != std::string::npos) {
        line.replace(at, 13, "blocking=False");
        ++changed;
      }
  ASSERT_EQ(changed, 1u);
  const Verification v = verify(this->read(text));
  EXPECT_FALSE(v.passed);
  EXPECT_NE(findingsText(v).find("ends by itself"), std::string::npos) << findingsText(v);
}

TEST_F(ToolChanges, TheOperatorReadsWhichToolToFit) {
  const test::ProgramText text = test::textOf(programFor("urscript"));
  EXPECT_TRUE(std::ranges::any_of(text.lines, [](const std::string& line) {
    return line.find("popup(\"Fit tool 2 (other, PETG, 235 C), then continue\"") !=
           std::string::npos;
  }));
}

TEST_F(ToolChanges, TheSignalsOfRapidAreListed) {
  const plan::Program program = programFor("rapid");
  const auto list = std::ranges::find_if(
      program.files, [](const plan::ProgramFile& file) { return file.name.ends_with(".cfg"); });
  ASSERT_NE(list, program.files.end());
  EXPECT_NE(list->text.find("-Name \"doTool2\" -SignalType \"DO\""), std::string::npos);
  EXPECT_EQ(list->text.find("doToolLocked"), std::string::npos) << "no tool changer";
}

// Its pendant shows the text: a remark would not reach the operator.
TEST_F(ToolChanges, TheOperatorReadsItOnEveryPendant) {
  for (const auto& [format, text] :
       {std::pair("rapid", "UIMsgBox \"Fit tool 2 (other, PETG, 235 C), then continue\""),
        std::pair("krl", "MsgNotify(\"Fit tool 2 (other, PETG, 235 C), then continue\")"),
        std::pair("spel", "Print \"Fit tool 2 (other, PETG, 235 C), then continue\""),
        std::pair("melfa", "Print #1,\"Fit tool 2 (other, PETG, 235 C), then continue\""),
        std::pair("gcode-extended", "M0 Fit tool 2 (other, PETG, 235 C), then continue")}) {
    const std::vector<std::string> lines = test::textOf(programFor(format)).lines;
    EXPECT_TRUE(std::ranges::any_of(lines, [&](const std::string& line) {
      return line.find(text) != std::string::npos;
    })) << format;
    EXPECT_TRUE(std::ranges::any_of(lines, [](const std::string& line) {
      return line.find("Is tool 1 (fdm-1.0, PLA, 210 C) fitted") != std::string::npos;
    })) << format;
    EXPECT_TRUE(std::ranges::any_of(lines, [](const std::string& line) {
      return line.find("the tips of all tools are expected in one place") != std::string::npos;
    })) << format;
  }
}

// Its pendant shows no texts: they go to the sender of the frames, as the head states.
TEST_F(ToolChanges, TmscriptSendsItsTexts) {
  const std::vector<std::string> lines = test::textOf(programFor("tmscript")).lines;
  EXPECT_TRUE(std::ranges::any_of(lines, [](const std::string& line) {
    return line.find("// the pendant shows no text at a stop") != std::string::npos;
  }));
  const auto text = std::ranges::find_if(lines, [](const std::string& line) {
    return line.starts_with("ListenSend(90,\"Fit tool 2 (other, PETG, 235 C), then continue\")");
  });
  ASSERT_NE(text, lines.end());
  EXPECT_TRUE((text - 1)->starts_with("QueueTag")) << "the motions before are done";
  EXPECT_TRUE((text + 1)->starts_with("Pause()"));
}

// The rest of a print may begin with any tool, which the program selects before it moves.
TEST_F(ToolChanges, AProgramBeginsWithItsOwnTool) {
  for (plan::ToolPath& path : scene_.plan.paths)
    path.tool = 1;
  scene_.trajectory.events.clear();
  scene_.trajectory.firstTool = 1;
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const plan::ReadProgram program = read(test::textOf(programFor(format)));
    EXPECT_TRUE(verify(program).passed) << findingsText(verify(program));
    EXPECT_TRUE(std::ranges::all_of(program.motions,
                                    [](const plan::ProgramMotion& m) { return m.tool == 1; }));
    const auto selected =
        std::ranges::find(program.facts, plan::FactKind::ToolSelected, &plan::StatedFact::kind);
    ASSERT_NE(selected, program.facts.end());
    plan::ReadProgram other = program;
    other.facts[static_cast<std::size_t>(selected - program.facts.begin())].tool = 0;
    expectAt(verify(other), selected->line);
    plan::ReadProgram none = program;
    none.facts.erase(none.facts.begin() + (selected - program.facts.begin()));
    EXPECT_FALSE(verify(std::move(none)).passed);
  }
}

// The steps of each change in another order, or with another text.
TEST_F(ToolChanges, EveryOtherOrderIsRefusedAtItsLine) {
  for (const std::string_view format : formats()) {
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    for (int change = 0; change < 2; ++change) {
      SCOPED_TRACE(std::string(format) + " change " + std::to_string(change));
      const Change at = changeOf(whole, change);
      { // The tool's output is switched before the stop in which it is fitted
        plan::ReadProgram p = whole;
        std::swap(p.facts[at.stop], p.facts[at.select]);
        expectAt(verify(std::move(p)), whole.facts[at.select].line);
      }
      { // The stop behind the purge
        plan::ReadProgram p = whole;
        plan::StatedFact stop = p.facts[at.stop];
        stop.beforePause = at.purge + 1;
        std::size_t behind = at.select;
        while (behind < p.facts.size() && p.facts[behind].before == stop.before)
          ++behind;
        p.facts.insert(p.facts.begin() + static_cast<std::ptrdiff_t>(behind), stop);
        p.facts.erase(p.facts.begin() + static_cast<std::ptrdiff_t>(at.stop));
        expectAt(verify(std::move(p)), whole.pauses[at.purge].line);
      }
      { // The purge before the change
        plan::ReadProgram p = whole;
        for (plan::StatedFact& fact : p.facts)
          if (fact.before == whole.facts[at.stop].before && fact.beforePause == at.purge)
            fact.beforePause = at.purge + 1;
        expectAt(verify(std::move(p)), whole.pauses[at.purge].line);
      }
      if (program::findDialect(format).showsTexts) { // Another material, another temperature
        for (const auto& [from, to] : {std::pair(change == 0 ? "PETG" : "PLA", "ABS"),
                                       std::pair(change == 0 ? "235" : "210", "120")}) {
          plan::ReadProgram p = whole;
          std::string& text = p.facts[at.stop].word;
          ASSERT_NE(text.find(from), std::string::npos) << text;
          text.replace(text.find(from), std::string_view(from).size(), to);
          expectAt(verify(std::move(p)), whole.facts[at.stop].line);
        }
      }
      if (at.heat) { // No wait for its heat
        plan::ReadProgram p = whole;
        p.facts.erase(p.facts.begin() + static_cast<std::ptrdiff_t>(*at.heat));
        EXPECT_FALSE(verify(std::move(p)).passed);
      }
    }
  }
}

// Before the stop the machine does not have the tool: its heat is in the change alone.
TEST_F(ToolChanges, AToolThatIsFittedByHandIsHeatedWhenItIsFitted) {
  for (const char* const format : {"gcode-extended", "gcode"}) {
    SCOPED_TRACE(format);
    const test::ProgramText whole = test::textOf(programFor(format));
    EXPECT_TRUE(verify(read(whole)).passed) << findingsText(verify(read(whole)));
    const auto lineOf = [](const test::ProgramText& text, const std::string& begin) {
      const auto at = std::ranges::find_if(
          text.lines, [&](const std::string& line) { return line.starts_with(begin); });
      return static_cast<std::size_t>(at - text.lines.begin()) + 1;
    };
    const std::size_t first = read(whole).motions.front().line, stop = lineOf(whole, "M0 Fit"),
                      heat = lineOf(whole, "M109 T1");
    EXPECT_GT(stop, first);
    EXPECT_EQ(heat, stop + 2);
    EXPECT_EQ(lineOf(whole, "M104 T1 S2"), whole.lines.size() + 1);
    EXPECT_LT(lineOf(whole, "M104 T0 S210"), first);
    const std::string word = "M109 T1 S235", early = "M104 T1 S235";
    const auto with = [&](const std::string& line, std::size_t before) {
      test::ProgramText text = whole;
      text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(before) - 1, line);
      return text;
    };
    for (const std::string& line : {word, early})
      for (const std::size_t before : {first, first + 20, stop, stop + 1}) {
        SCOPED_TRACE(line + " before line " + std::to_string(before));
        expectAt(verify(read(with(line, before))), before);
      }
    EXPECT_TRUE(verify(read(with(early, heat))).passed);
    test::ProgramText lost = whole;
    lost.lines.erase(lost.lines.begin() + static_cast<std::ptrdiff_t>(heat) - 1);
    std::size_t next = 0;
    for (const plan::ProgramMotion& motion : read(lost).motions)
      if (next == 0 && motion.line > heat)
        next = motion.line;
    expectAt(verify(read(lost)), next);
    for (const char* other : {"M109 T1 S210", "M109 T1 S0", "M109 T0 S210", "M104 T1 S235"}) {
      SCOPED_TRACE(other);
      test::ProgramText text = whole;
      text.lines[heat - 1] = other;
      EXPECT_FALSE(verify(read(text)).passed);
    }
  }
  // A feeder switches between tools that the machine has: they are hot from the start.
  std::erase_if(scene_.trajectory.events, [](const plan::TrajectoryEvent& event) {
    return event.kind == plan::EventKind::Pause;
  });
  const test::ProgramText fed = test::textOf(programFor("gcode-extended"));
  EXPECT_TRUE(verify(read(fed)).passed) << findingsText(verify(read(fed)));
  const auto hot = std::ranges::find(fed.lines, "M109 T1 S235");
  ASSERT_NE(hot, fed.lines.end());
  EXPECT_LT(static_cast<std::size_t>(hot - fed.lines.begin()), read(fed).motions.front().line);
}

// Statements before the first motion: an earlier run may have left another tool selected.
TEST_F(ToolChanges, TheFirstSelectionIsNeeded) {
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram whole = read(text);
    const auto first =
        std::ranges::find(whole.facts, plan::FactKind::ToolSelected, &plan::StatedFact::kind);
    ASSERT_NE(first, whole.facts.end());
    ASSERT_EQ(first->before, whole.firstMotion);
    test::ProgramText lost = text;
    lost.lines.erase(lost.lines.begin() + static_cast<std::ptrdiff_t>(first->line) - 1);
    EXPECT_FALSE(verify(read(lost)).passed);
    plan::ReadProgram early = whole;
    const auto stop =
        std::ranges::find(early.facts, plan::FactKind::OperatorStop, &plan::StatedFact::kind);
    const auto select = early.facts.begin() + (first - whole.facts.begin());
    ASSERT_LT(stop, select) << "selected before the operator is asked";
    std::swap(*stop, *select);
    expectAt(verify(std::move(early)), first->line);
  }
}

// Of three tools each has an output, all of which are stated.
TEST_F(ToolChanges, EveryOutputIsSetAtTheStart) {
  tooling_ = process::Tooling(
      std::vector<process::Tool>{tooling_.tools()[0], tooling_.tools()[1], tooling_.tools()[0]});
  test::ProgramText text = test::textOf(programFor("urscript"));
  ASSERT_TRUE(read(text).defects.empty());
  text.lines.erase(std::ranges::find(text.lines, "  set_standard_digital_out(2,False)"));
  EXPECT_FALSE(read(text).defects.empty());
}

// Lines of the text whose statement belongs to a change.
TEST_F(ToolChanges, ADeletedLineIsRefused) {
  for (const std::string_view format : formats()) {
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram whole = read(text);
    std::vector<std::size_t> lines;
    for (const plan::StatedFact& fact : whole.facts)
      if ((fact.kind == plan::FactKind::ToolSelected ||
           fact.kind == plan::FactKind::OperatorStop) &&
          fact.before > whole.firstMotion)
        lines.push_back(fact.line);
    for (const plan::ProgramPause& pause : whole.pauses)
      if (std::abs(pause.volumeMm3 - kPurgeMm3) < 0.2)
        lines.push_back(pause.line);
    EXPECT_GE(lines.size(), 4u) << format;
    for (const std::size_t line : lines) {
      SCOPED_TRACE(std::string(format) + " line " + std::to_string(line) + ": " +
                   text.lines[line - 1]);
      test::ProgramText damaged = text;
      damaged.lines.erase(damaged.lines.begin() + static_cast<std::ptrdiff_t>(line) - 1);
      const Verification v = verify(read(damaged));
      EXPECT_FALSE(v.passed);
    }
  }
}

// Forty edits: a change left out, added, to the wrong tool or at another motion; a pause left out;
// a purge left out, smaller or larger.
TEST_F(ToolChanges, EveryEditIsRefused) {
  std::vector<plan::ReadProgram> programs;
  for (const std::string_view format : formats())
    programs.push_back(read(test::textOf(programFor(format))));
  std::mt19937 random(41);
  for (int edit = 0; edit < 40; ++edit) {
    plan::ReadProgram program = programs[random() % programs.size()];
    std::vector<std::size_t> changes, stops, purges;
    for (std::size_t f = 0; f < program.facts.size(); ++f) {
      const plan::StatedFact& fact = program.facts[f];
      if (fact.before <= program.firstMotion)
        continue;
      if (fact.kind == plan::FactKind::ToolSelected)
        changes.push_back(f);
      if (fact.kind == plan::FactKind::OperatorStop)
        stops.push_back(f);
    }
    for (std::size_t p = 0; p < program.pauses.size(); ++p)
      if (std::abs(program.pauses[p].volumeMm3 - kPurgeMm3) < 0.2)
        purges.push_back(p);
    ASSERT_EQ(changes.size(), 2u);
    ASSERT_EQ(stops.size(), 2u);
    ASSERT_EQ(purges.size(), 2u);
    const std::size_t which = random() % 2;
    const auto change = program.facts.begin() + static_cast<std::ptrdiff_t>(changes[which]);
    const auto purge = program.pauses.begin() + static_cast<std::ptrdiff_t>(purges[which]);
    const double share = 0.05 + 0.9 * static_cast<double>(random() % 1000) / 1000.0;
    const auto kind = static_cast<int>(random() % 8);
    SCOPED_TRACE(program.format + " edit " + std::to_string(kind));
    if (kind == 0)
      program.facts.erase(change);
    else if (kind == 1)
      change->tool = 1 - change->tool;
    else if (kind == 2)
      change->before += 3 + random() % 20;
    else if (kind == 3)
      addOtherTool(program, change);
    else if (kind == 4)
      program.facts.erase(program.facts.begin() + static_cast<std::ptrdiff_t>(stops[which]));
    else if (kind == 5)
      program.pauses.erase(purge);
    else if (kind == 6)
      purge->volumeMm3 *= share;
    else
      purge->volumeMm3 *= 1.05 + share;
    const Verification v = verify(std::move(program));
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::StatementMissing ||
             f.kind == plan::FindingKind::StatementChanged;
    })) << findingsText(v);
  }
}

// The operator takes the tool off at the stop: its heat is off by then and stays off.
TEST_F(ToolChanges, TheHeatOfARemovedToolIsOffBeforeTheStop) {
  std::size_t languages = 0;
  for (const std::string_view format : formats()) {
    const test::ProgramText text = test::textOf(programFor(format));
    if (std::ranges::find(text.lines, "G28") == text.lines.end())
      continue;
    SCOPED_TRACE(format);
    ++languages;
    EXPECT_TRUE(verify(read(text)).passed) << findingsText(verify(read(text)));
    for (const auto& [stop, off] :
         {std::pair("M0 Fit tool 2", "M104 T0 S0"), std::pair("M0 Fit tool 1", "M104 T1 S0")}) {
      const auto at = std::ranges::find_if(
          text.lines, [&](const std::string& line) { return line.starts_with(stop); });
      ASSERT_NE(at, text.lines.end());
      const auto stopAt = at - text.lines.begin();
      ASSERT_EQ(text.lines[static_cast<std::size_t>(stopAt) - 1], off);
      const auto line = static_cast<std::size_t>(stopAt);

      test::ProgramText missing = text;
      missing.lines.erase(missing.lines.begin() + stopAt - 1);
      expectAt(verify(read(missing)), line);

      test::ProgramText late = text;
      std::swap(late.lines[line - 1], late.lines[line]);
      expectAt(verify(read(late)), line);

      test::ProgramText again = text;
      std::string heat = off;
      heat.back() = '2';
      again.lines.insert(again.lines.begin() + stopAt + 1, heat + "10");
      expectAt(verify(read(again)), line + 2);
    }
  }
  EXPECT_GE(languages, 1u);
}

// The plate is heated behind the question.
TEST_F(ToolChanges, GcodeAsksForTheToolAndTheWayHome) {
  const test::ProgramText text = test::textOf(programFor("gcode-extended"));
  EXPECT_EQ(std::ranges::count_if(text.lines,
                                  [](const std::string& line) {
                                    return line.starts_with(
                                               "M0 The machine drives home and then to its start. "
                                               "Is tool 1 (fdm-1.0, ") &&
                                           line.ends_with(") fitted and the way clear?");
                                  }),
            1);
  EXPECT_TRUE(std::ranges::none_of(text.lines, [](const std::string& line) {
    return line.starts_with("M0") && line.find("plate") != std::string::npos;
  }));
}

// Outputs of two tools that are on at once are refused.
TEST_F(ToolChanges, OutputsOfSeveralToolsAreRefused) {
  tooling_ = process::Tooling(
      std::vector<process::Tool>{tooling_.tools()[0], tooling_.tools()[1], tooling_.tools()[0]});
  const test::ProgramText text = test::textOf(programFor("urscript"));
  EXPECT_TRUE(read(text).defects.empty());
  test::ProgramText damaged = text;
  const char* const kOff = "  set_standard_digital_out(2,False)";
  const auto atStart = std::ranges::find(damaged.lines, kOff);
  ASSERT_NE(atStart, damaged.lines.end());
  *std::find(atStart + 1, damaged.lines.end(), kOff) = "  set_standard_digital_out(2,True)";
  EXPECT_FALSE(read(damaged).defects.empty());
}

// The output of a tool changer: each line left out is refused, and so is a tool that is released at
// the start of the program.
TEST_F(ToolChanges, AChangerReleasesAndLocksWhereItIsPlanned) {
  useChanger();
  std::size_t lines = 0;
  for (const std::string_view format : formats()) {
    if (std::ranges::find(program::findDialect(format).events, plan::EventKind::Lock) ==
        program::findDialect(format).events.end())
      continue;
    SCOPED_TRACE(format);
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram whole = read(text);
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    for (const plan::StatedFact& fact : whole.facts) {
      if (fact.kind != plan::FactKind::ToolLocked)
        continue;
      test::ProgramText damaged = text;
      damaged.lines.erase(damaged.lines.begin() + static_cast<std::ptrdiff_t>(fact.line) - 1);
      EXPECT_FALSE(verify(read(damaged)).passed) << fact.line;
      ++lines;
    }
    plan::ReadProgram released = whole;
    plan::StatedFact atStart;
    atStart.kind = plan::FactKind::ToolLocked;
    released.facts.insert(released.facts.begin(), atStart);
    EXPECT_FALSE(verify(std::move(released)).passed);
  }
  EXPECT_GE(lines, 12u);
}

// The time of a release or a lock passes before the next step.
TEST_F(ToolChanges, TheTimeOfAChangerPassesBeforeTheNextStep) {
  useChanger();
  for (const char* const format : {"urscript", "rapid", "krl", "spel", "melfa", "tmscript"}) {
    SCOPED_TRACE(format);
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    for (std::size_t f = 0; f < whole.facts.size(); ++f) {
      const plan::StatedFact& fact = whole.facts[f];
      if (fact.kind != plan::FactKind::ToolLocked || fact.before <= whole.firstMotion)
        continue;
      plan::ReadProgram early = whole; // its wait comes before it
      early.facts[f].beforePause += 1;
      expectAt(verify(std::move(early)), fact.line);
    }
  }
}

TEST_F(ToolChanges, AnExtruderThatTakesTextsPrintsWithOneTool) {
  program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"};
  input.options.own["extruder"] = "castelli-serial";
  EXPECT_THROW(program::writeProgram("urscript", input), base::Error);
}

} // namespace
} // namespace voluta::replay
