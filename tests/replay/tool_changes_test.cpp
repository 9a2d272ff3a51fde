// Tool changes in programs of every dialect that has them: they are read back and replayed, and a
// missing, added or wrong tool, a missing pause and a missing or changed purge are refused.
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/event_programs.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

constexpr double kPurgeMm3 = 50.0, kPurgeS = 4.0;

// A box of four layers, the second and the third of them by tool 2.
class ToolChanges : public EventPrograms {
protected:
  void SetUp() override {
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
      t.events.push_back({.point = i, .kind = plan::EventKind::ToolChange, .tool = tool});
      t.events.push_back({.point = i, .kind = plan::EventKind::Pause});
      t.events.push_back(
          {.point = i, .kind = plan::EventKind::Purge, .seconds = kPurgeS, .volumeMm3 = kPurgeMm3});
    }
    ASSERT_EQ(t.events.size(), 6u);
  }
  static std::vector<std::string_view> formats() {
    return formatsWith(plan::EventKind::ToolChange);
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
    EXPECT_TRUE(v.passed) << told(v);
    EXPECT_NEAR(v.massRatio, 1.0, 0.02);
  }
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
    })) << told(v);
  }
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
  std::vector<plan::TrajectoryEvent> events;
  for (const plan::TrajectoryEvent& event : scene_.trajectory.events)
    if (event.kind == plan::EventKind::ToolChange) {
      events.push_back({.point = event.point, .kind = plan::EventKind::Release, .seconds = 1.0});
      events.push_back(event);
      events.push_back({.point = event.point, .kind = plan::EventKind::Lock, .seconds = 1.0});
    }
  scene_.trajectory.events = events;
  std::size_t lines = 0;
  for (const std::string_view format : formats()) {
    if (std::ranges::find(program::findDialect(format).events, plan::EventKind::Lock) ==
        program::findDialect(format).events.end())
      continue;
    SCOPED_TRACE(format);
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram whole = read(text);
    EXPECT_TRUE(verify(whole).passed) << told(verify(whole));
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

TEST_F(ToolChanges, AnExtruderThatTakesTextsPrintsWithOneTool) {
  program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"};
  input.options.own["extruder"] = "castelli-serial";
  EXPECT_THROW(program::writeProgram("urscript", input), base::Error);
}

} // namespace
} // namespace voluta::replay
