// Statements of a program beside its motions: waits, prime, load, accelerations, at its line.
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/beside_motion.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <sstream>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(1);
  return s;
}

test::ProgramText textOf(const std::string& format) {
  const test::Scene& s = scene();
  return test::textOf(program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"}));
}

Verification verify(const test::ProgramText& text) {
  const test::Scene& s = scene();
  return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                        process::Tooling(s.process), s.part, s.platform},
                       ReplayThresholds{}, {});
}

// Behind the line of a motion within a bead.
void insertDuringPrint(test::ProgramText& text, const std::string& line, std::size_t& at) {
  at = test::read(text, scene().process).motions[8].line + 1;
  text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(at - 1),
                    text.format == "rapid" ? line + "\r" : line);
}

bool reportedAt(const Verification& v, const std::string& word, std::size_t line) {
  for (std::size_t i = 0; i < v.findings.size(); ++i)
    if (voluta::plan::reportId(v.findings[i]) == word && v.places[i].line + 1 >= line &&
        v.places[i].line <= line + 1)
      return true;
  return false;
}

TEST(BesideMotion, AWaitInWhichMaterialFlowsIsFound) {
  const struct {
    const char *format, *line, *word;
  } cases[] = {
      {"urscript", "  sleep(600)", "flowsWhileStanding"},
      {"urscript", "  sleep(0.1)", "flowsWhileStanding"},
      {"rapid", "    WaitTime 600;", "flowsWhileStanding"},
      {"gcode-extended", "G4 S600", "standsAmidPrint"},
      {"gcode-extended", "G1 E-300 F60", "unreadableLine"},
      {"gcode-extended", "G28", "unreadableLine"},
      {"gcode-extended", "M84", "unreadableLine"},
      {"gcode-extended", "M104 S0", "unreadableLine"},
      {"gcode-extended", "M104 S400", "unreadableLine"},
      {"gcode-extended", "T1", "unreadableLine"},
      {"urscript", "  set_payload(20)", "unreadableLine"},
      {"urscript", "  set_gravity([0,0,9.82])", "unreadableLine"},
      {"urscript", "  set_analog_outputdomain(0,0)", "unreadableLine"},
      {"rapid", "    AccSet 20,100;", "unreadableLine"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    test::ProgramText text = textOf(c.format);
    std::size_t at = 0;
    insertDuringPrint(text, c.line, at);
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(reportedAt(v, c.word, at)) << at << "\n" << findingsText(v);
  }
}

TEST(BesideMotion, FlowDuringAWaitIsCounted) {
  test::ProgramText text = textOf("urscript");
  const Verification sound = verify(text);
  std::size_t at = 0;
  insertDuringPrint(text, "  sleep(10)", at);
  const Verification v = verify(text);
  const double flow = test::read(text, scene().process).motions[8].flowMm3PerS;
  EXPECT_NEAR(v.depositedMm3 - sound.depositedMm3, 10.0 * flow, 1e-6);
  EXPECT_NEAR(v.durationS - sound.durationS, 10.0, 1e-9);
  EXPECT_NEAR(v.excessFraction - sound.excessFraction, 10.0 * flow / v.partVolumeMm3, 1e-9);
}

TEST(BesideMotion, AMissingOrOtherPrimeIsFound) {
  for (const program::Dialect& d : test::dialectsFor("urscript")) {
    const test::ProgramText whole = textOf(std::string(d.id));
    const plan::ReadProgram read = test::read(whole, scene().process);
    if (!read.tellsPauses)
      continue;
    double volume = 0.0;
    for (const plan::ProgramPause& p : read.pauses)
      volume += p.volumeMm3;
    EXPECT_NEAR(volume, plannedPrimeMm3(scene().plan, scene().trajectory, scene().process), 1e-3)
        << d.id;
    const auto wait = std::find_if(read.pauses.begin(), read.pauses.end(),
                                   [](const plan::ProgramPause& p) { return p.volumeMm3 > 0.0; });
    ASSERT_NE(wait, read.pauses.end());
    test::ProgramText without = whole;
    without.lines.erase(without.lines.begin() + static_cast<std::ptrdiff_t>(wait->line - 1));
    const Verification v = verify(without);
    EXPECT_FALSE(v.passed) << d.id;
    EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::PrimeChanged;
    })) << findingsText(v);
  }
}

// Numbers of the line that holds `mark`, by their names there.
std::size_t change(test::ProgramText& text, const std::string& mark, const std::string& from,
                   const std::string& to) {
  for (std::size_t i = 0; i < text.lines.size(); ++i)
    if (const std::size_t at = text.lines[i].find(from);
        at != std::string::npos && text.lines[i].find(mark) != std::string::npos) {
      text.lines[i].replace(at, from.size(), to);
      return i + 1;
    }
  ADD_FAILURE() << mark << " " << from;
  return 0;
}

TEST(BesideMotion, LoadFirstMotionAndAccelerationsAreHeldToThePlan) {
  const struct {
    const char *format, *mark, *from, *to, *word;
  } cases[] = {
      {"urscript", "set_payload", "(0.5", "(20", "loadChanged"},
      {"urscript", "set_payload", "(0.5", "(2.4",
       "loadChanged"}, // more than a kilogram, and thrice
      {"urscript", "movej", "v=0.25", "v=2", "firstMotionFast"},
      {"urscript", "movej", "a=0.5", "a=4.2", "firstMotionFast"},
      {"rapid", "MoveJ", "[50,", "[1000,", "firstMotionFast"},
      {"urscript", "movel", "t=0", "t=9", "speedChanged"}, // it rules over the acceleration
      {"rapid", "tooldata", "[0.5", "[20", "loadChanged"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.format) + " " + c.to);
    test::ProgramText text = textOf(c.format);
    const std::size_t line = change(text, c.mark, c.from, c.to);
    ASSERT_GT(line, 0u);
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(reportedAt(v, c.word, line)) << line << ": " << text.lines[line - 1] << "\n"
                                             << findingsText(v);
  }
}

// Each dialect whose text has the nozzle's frame: another first digit after the text before it.
// Where targets are the arm's (melfa, its lines, spel) nothing else shows it on a plate that does
// not turn.
TEST(BesideMotion, AnotherNozzleIsFound) {
  const struct {
    const char *format, *mark, *before;
  } cases[] = {{"melfa-datalink", "nozzle,", "nozzle,"},
               {"krl-eki", "nozzle,", "nozzle,"},
               {"melfa", "P_WkCord(1)=", "=("},
               {"spel", "ECPSet 1", "XY("},
               {"krl", "$BASE=", "{X "},
               {"rapid", "PERS tooldata", "[["}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.format);
    test::ProgramText text = textOf(c.format);
    const auto said = std::ranges::find_if(text.lines, [&](const std::string& line) {
      return line.find(c.mark) != std::string::npos && line.find(c.before) != std::string::npos;
    });
    ASSERT_NE(said, text.lines.end());
    const std::size_t at =
        said->find_first_of("0123456789", said->find(c.before) + std::strlen(c.before));
    ASSERT_NE(at, std::string::npos);
    said->insert(at, "1");
    const std::size_t line = static_cast<std::size_t>(said - text.lines.begin()) + 1;
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed);
    const std::size_t first = test::read(text, scene().process).motions.front().line;
    EXPECT_TRUE(reportedAt(v, "nozzleElsewhere", line) || reportedAt(v, "nozzleElsewhere", first))
        << *said << "\n"
        << findingsText(v);
  }
}

// A hair's breadth is within the accuracy of a frame written by hand.
TEST(BesideMotion, NozzleMayDeviateWithinTheTolerance) {
  test::ProgramText text = textOf("melfa-datalink");
  const auto row = std::ranges::find_if(
      text.lines, [](const std::string& line) { return line.starts_with("nozzle,"); });
  ASSERT_NE(row, text.lines.end());
  const robot::Cell& cell = scene().cell;
  for (const double off : {0.03, 0.08}) {
    const Eigen::Vector3d at = cell.base_T_fixed().translation();
    std::vector<std::string> numbers;
    std::istringstream in(*row);
    for (std::string number; std::getline(in, number, ',');)
      numbers.push_back(number);
    ASSERT_EQ(numbers.size(), 7u);
    numbers[3] = std::to_string(at.z() + off);
    std::string other = numbers[0];
    for (std::size_t k = 1; k < numbers.size(); ++k)
      other += "," + numbers[k];
    test::ProgramText changed = text;
    changed.lines[static_cast<std::size_t>(row - text.lines.begin())] = other;
    const Verification v = verify(changed);
    EXPECT_EQ(v.passed, off < 0.05) << findingsText(v);
  }
}

TEST(BesideMotion, ALoadMayDifferByAKilogram) {
  test::ProgramText text = textOf("urscript");
  ASSERT_GT(change(text, "set_payload", "(0.5", "(1.4"), 0u);
  const Verification v = verify(text);
  EXPECT_TRUE(v.passed) << findingsText(v);
}

} // namespace
} // namespace voluta::replay
