// Statements of a program beside its motions whose check needs a scene or an extruder of its own:
// names of units, triggers within a bead, texts that heat, posture flags of MELFA's own arm, waits
// that are planned. All else is among the mutations (stated_mutations.h).
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "program/full_flow.h"
#include "program/text_damage.h"
#include "replay/replay_scene.h"
#include "replay/required_facts.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

test::ProgramText write(const test::Scene& s, const std::string& format,
                        std::string_view extruder = program::kOutputsExtruder) {
  program::ProgramInput input{s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"};
  input.options.own[std::string(program::kExtruderOption)] = std::string(extruder);
  return test::textOf(program::writeProgram(format, input));
}

Verification verify(const test::Scene& s, const test::ProgramText& text) {
  return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                        process::Tooling(s.process), s.part, s.platform},
                       ReplayThresholds{}, {});
}

// Replaces the pattern in all lines, or in the first that it is in; that one, 1-based.
std::size_t replace(test::ProgramText& text, const std::string& pattern, const std::string& by,
                    bool everywhere = true) {
  const std::regex expression(pattern);
  std::size_t first = 0;
  for (std::size_t i = 0; i < text.lines.size() && (everywhere || first == 0); ++i) {
    const std::string now = std::regex_replace(text.lines[i], expression, by);
    if (now != text.lines[i])
      first = first == 0 ? i + 1 : first;
    text.lines[i] = now;
  }
  return first;
}

void expectRefused(const Verification& v, const std::string& word, std::size_t line) {
  EXPECT_FALSE(v.passed);
  bool here = false;
  for (std::size_t i = 0; i < v.findings.size(); ++i)
    here = here || (voluta::plan::reportId(v.findings[i]) == word && v.places[i].line == line);
  EXPECT_TRUE(here) << word << " at line " << line << "\n" << findingsText(v);
}

TEST(StatedFacts, AUnitOfAnotherNameIsFound) {
  const test::Scene s = test::rodScene();
  const struct {
    const char *format, *pattern, *by, *at;
  } cases[] = {{"rapid", "(ActUnit |\")rod\\b", "$1spindle", "ActUnit"},
               {"krl", "MACHINE_DEF\\[2\\]", "MACHINE_DEF[3]", "MACHINE_DEF"},
               {"krl", "MACHINE_DEF\\[2\\]\\.ROOT", "MACHINE_DEF[3].ROOT", "MACHINE_DEF"}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.by);
    test::ProgramText text = write(s, c.format);
    // KRL's ramps cost it the flow of these short rings; its text is the plan's.
    ASSERT_EQ(verify(s, text).deviations, 0U) << findingsText(verify(s, text));
    ASSERT_GT(replace(text, c.pattern, c.by), 0U);
    std::size_t line = 0;
    for (std::size_t i = 0; i < text.lines.size() && line == 0; ++i)
      if (std::regex_search(text.lines[i], std::regex(std::string("^ *[^ !;].*") + c.at)) ||
          text.lines[i].find(std::string("    ") + c.at) == 0)
        line = i + 1;
    expectRefused(verify(s, text), "statementChanged", line);
  }
}

// Its beads are slower in the middle, so that the flow changes where the arm does not stop.
test::Scene changingFlow() {
  test::Scene s = test::boxScene(1);
  for (const plan::ToolPath& path : s.plan.paths)
    for (std::size_t w = path.first; w < path.first + path.count; ++w)
      if (w - path.first > path.count / 3 && w - path.first <= 2 * path.count / 3)
        s.plan.speedMmPerS[w] *= 0.8f;
  s.trajectory = test::walk(s.plan, s.cell, s.process);
  return s;
}

TEST(StatedFacts, AnOutputWithoutItsTriggerIsFound) {
  const test::Scene s = changingFlow();
  for (const bool all : {false, true}) {
    test::ProgramText rapid = write(s, "rapid");
    ASSERT_TRUE(verify(s, rapid).passed) << findingsText(verify(s, rapid));
    const std::size_t at = replace(rapid, "TriggEquip tFlow,0\\\\Start,0\\\\AOp:=aoFlow,([0-9.]+);",
                                   "SetAO aoFlow,$1;", all);
    replace(rapid, "TriggL (.*),tFlow,", "MoveL $1,", all);
    expectRefused(verify(s, rapid), "outputPasses", at);

    test::ProgramText krl = write(s, "krl");
    ASSERT_TRUE(verify(s, krl).passed) << findingsText(verify(s, krl));
    const std::size_t line = replace(krl, "TRIGGER WHEN DISTANCE=0 DELAY=0 DO ", "", all);
    expectRefused(verify(s, krl), "outputPasses", line);
  }
}

TEST(StatedFacts, AnExtruderByTextsHasToBeHeated) {
  const test::Scene s = test::boxScene(1);
  for (const char* format : {"urscript", "spel"}) {
    SCOPED_TRACE(format);
    test::ProgramText text = write(s, format, program::kCastelliExtruder);
    ASSERT_TRUE(verify(s, text).passed) << findingsText(verify(s, text));
    test::ProgramText cold = text;
    const std::size_t heat = replace(cold, "M210n", "M0n");
    expectRefused(verify(s, cold), "statementChanged", heat);
    text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(heat - 1));
    expectRefused(verify(s, text), "statementMissing",
                  test::read(text, s.process).motions.front().line);
  }
}

TEST(StatedFacts, FlagsAreThoseOfTheCellsOwnArm) {
  const test::Scene s = test::boxScene(1, "rv2f-moving");
  const test::ProgramText whole = write(s, "melfa");
  const Verification sound = verify(s, whole);
  ASSERT_TRUE(sound.passed) << findingsText(sound);
  const std::size_t line = test::read(whole, s.process).motions[8].line;
  std::smatch flags;
  const std::regex pattern("\\((\\d+),(\\d+)\\)");
  ASSERT_TRUE(std::regex_search(whole.lines[line - 1], flags, pattern));
  for (const std::string& other :
       {"(" + std::to_string(std::stoi(flags[1]) ^ 4) + "," + flags[2].str() + ")",
        "(" + flags[1].str() + "," + std::to_string(std::stoul(flags[2]) ^ 1048576U) + ")"}) {
    test::ProgramText text = whole;
    text.lines[line - 1] = std::regex_replace(text.lines[line - 1], pattern, other);
    expectRefused(verify(s, text), "postureChanged", line);
  }
}

// The same poses of the arm's other wrist.
void flipWrist(plan::Trajectory& t) {
  const double* first = t.joints.data() + t.dof; // Behind the point beside the print
  const double first4 = first[3], first6 = first[5];
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    double* q = t.joints.data() + i * static_cast<std::size_t>(t.dof);
    q[3] += first4 > 0.0 ? -base::kPi : base::kPi;
    q[4] = -q[4];
    q[5] += first6 > 0.0 ? -base::kPi : base::kPi;
  }
}

// Without flags the controller takes (7,0), with one alone no turns.
TEST(StatedFacts, FlagsThatAreLeftOutAreThoseThatTheControllerTakes) {
  int taken = 0;
  for (const bool turned : {false, true}) {
    test::Scene s = test::boxScene(1, "rv2f-moving");
    if (turned)
      flipWrist(s.trajectory);
    const test::ProgramText whole = write(s, "melfa");
    ASSERT_TRUE(verify(s, whole).passed) << findingsText(verify(s, whole));
    const std::size_t line = test::read(whole, s.process).motions[8].line;
    const std::regex pattern("\\)\\((\\d+),(\\d+)\\)");
    std::smatch flags;
    ASSERT_TRUE(std::regex_search(whole.lines[line - 1], flags, pattern));
    const bool noTurns = flags[2] == "0";
    taken += noTurns ? 1 : 0;
    for (const std::string some : {"", "(7)", "(6)"}) {
      test::ProgramText text = whole;
      text.lines[line - 1] = std::regex_replace(text.lines[line - 1], pattern, ")" + some);
      if (noTurns && (some.empty() ? "7" : some.substr(1, 1)) == flags[1].str())
        EXPECT_TRUE(verify(s, text).passed) << some << findingsText(verify(s, text));
      else
        expectRefused(verify(s, text), "postureChanged", line);
    }
  }
  EXPECT_GE(taken, 1); // of the other wrist axis 4 is half a turn further
}

// The full flow in a head is compared with the process.
TEST(StatedFacts, AFullFlowMayBeRounded) {
  test::Scene s = test::boxScene(1);
  for (const double flow : {0.2344, 0.0126, 1.9995, 40.0}) {
    s.process.maxFlowMm3PerS = flow;
    const auto findings = [&](const std::string& text) {
      plan::ReadProgram read;
      read.format = "urscript";
      read.facts = program::statedFullFlow(
          {{"a.script", "# extruder on: DO 0; flow: AO 0, " + text + "\n"}});
      EXPECT_EQ(read.facts.size(), 1U);
      return compareStatedFacts(read, s.trajectory, {}, s.cell, process::Tooling(s.process));
    };
    EXPECT_TRUE(findings(program::fullFlowText("1", process::Tooling(s.process))).empty()) << flow;
    EXPECT_FALSE(findings("1 = " + std::to_string(1.01 * flow + 0.001) + " mm3/s").empty()) << flow;
    EXPECT_FALSE(findings("1 = 7 mm3/min").empty());
  }
}

// Of a stop that ends by itself, and of corners without distances, the line itself is wrong.
TEST(StatedFacts, WrongStatementsAreChangedAndNotMissing) {
  const test::Scene s = test::boxScene(1);
  test::ProgramText gcode = write(s, "gcode-extended");
  const std::size_t stop = replace(gcode, "^M0$", "M0 P100");
  expectRefused(verify(s, gcode), "statementChanged", stop);
  test::ProgramText melfa = write(s, "melfa");
  const std::size_t rounding = replace(melfa, "Cnt 1,[0-9.,]+", "Cnt 1", false);
  expectRefused(verify(s, melfa), "statementChanged", rounding);
}

// The range of an output that carries no flow is the user's own matter.
TEST(StatedFacts, ARangeIsNeededWhereTheOutputCarriesTheFlow) {
  const test::Scene s = test::boxScene(1);
  test::ProgramText text = write(s, "urscript");
  const std::size_t line = replace(text, "^ *set_analog_outputdomain.*$", "");
  ASSERT_GT(line, 0U);
  expectRefused(verify(s, text), "statementMissing", test::read(text, s.process).motions[0].line);
  const test::ProgramText sent = write(s, "urscript", program::kCastelliExtruder);
  EXPECT_TRUE(verify(s, sent).passed) << findingsText(verify(s, sent));
}

TEST(StatedFacts, WaitsThatThePlanHasAreNone) {
  test::Scene s = test::boxScene(1);
  s.process.retractMm = 2.0;
  for (const char* format : {"gcode-extended", "gcode-bc"}) {
    SCOPED_TRACE(format);
    test::ProgramText text = write(s, format);
    const Verification sound = verify(s, text);
    ASSERT_TRUE(sound.passed) << findingsText(sound);
    const bool perMinute = std::string(format) == "gcode-extended";
    const std::size_t line =
        replace(text, "^(G1 E[-0-9.]+ F)" + std::string(perMinute ? "1800" : "900") + "$",
                perMinute ? "$01120" : "$0160");
    ASSERT_GT(line, 0U);
    expectRefused(verify(s, text), "standsAmidPrint", line);
  }
}

TEST(StatedFacts, VeryShortWaitIsIgnored) {
  const test::Scene s = test::boxScene(1);
  test::ProgramText text = write(s, "gcode-extended");
  const std::size_t line = test::read(text, s.process).motions[8].line;
  text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(line), "G4 P50");
  EXPECT_TRUE(verify(s, text).passed);
  text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(line), "G4 P100");
  expectRefused(verify(s, text), "standsAmidPrint", line + 1);
}

} // namespace
} // namespace voluta::replay
