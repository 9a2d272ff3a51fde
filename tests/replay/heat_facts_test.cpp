// Programs that extrude cold, on a cold bed, or with the fan at another speed.
#include "replay/heat_facts.h"

#include "plan/finding_kinds.h"
#include "process/cooling.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "program/text_damage.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using test::ProgramText;

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(2);
  return s;
}

ProgramText write(const test::Scene& s, const std::string& format) {
  program::ProgramInput input{s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"};
  if (format == "urscript" || format == "spel")
    input.options.own[std::string(program::kExtruderOption)] =
        std::string(program::kCastelliExtruder);
  return test::textOf(program::writeProgram(format, input));
}

Verification verify(const test::Scene& s, const ProgramText& text) {
  return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                        process::Tooling(s.process), s.part, s.platform},
                       ReplayThresholds{}, {});
}

// 1-based; 0: there is none.
std::size_t lineWith(const ProgramText& text, const std::string& part) {
  for (std::size_t i = 0; i < text.lines.size(); ++i)
    if (text.lines[i].find(part) != std::string::npos)
      return i + 1;
  return 0;
}
void eraseAll(ProgramText& text, const std::string& part) {
  std::erase_if(text.lines,
                [&](const std::string& line) { return line.find(part) != std::string::npos; });
}
void insertBefore(ProgramText& text, std::size_t line, const std::string& what) {
  text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(line) - 1, what);
}
void replaceAll(ProgramText& text, const std::string& from, const std::string& to) {
  for (std::string& line : text.lines)
    if (const std::size_t at = line.find(from); at != std::string::npos)
      line.replace(at, from.size(), to);
}

// A line of a bead, not its first or last.
std::size_t insideBead(const ProgramText& text, const test::Scene& s, std::mt19937_64& random) {
  const plan::ReadProgram read = test::read(text, s.process);
  std::vector<std::size_t> lines;
  for (std::size_t m = 1; m + 1 < read.motions.size(); ++m)
    if (read.motions[m - 1].extruding && read.motions[m].extruding && read.motions[m + 1].extruding)
      lines.push_back(read.motions[m].line);
  return lines[random() % lines.size()];
}

// Damages the text; returns the lines of which one is named, 0: any.
struct Edit {
  const char* name;
  std::function<std::vector<std::size_t>(ProgramText&, const test::Scene&, std::mt19937_64&)> apply;
};

std::size_t firstMotion(const ProgramText& text, const test::Scene& s) {
  return test::read(text, s.process).motions.front().line;
}

std::vector<Edit> gcodeEdits() {
  return {{"without M109",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64&) {
             eraseAll(t, "M109");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"without M104 and M109",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64&) {
             eraseAll(t, "M109");
             eraseAll(t, "M104 S210");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"too cold",
           [](ProgramText& t, const test::Scene&, std::mt19937_64& random) {
             const std::size_t line = lineWith(t, "M109");
             replaceAll(t, "M109 S210", "M109 S" + std::to_string(20 + random() % 150));
             return std::vector<std::size_t>{line};
           }},
          {"off amid the print",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64& random) {
             const std::size_t line = insideBead(t, s, random);
             insertBefore(t, line, random() % 2 == 0 ? "M104 S0" : "M109 S0");
             return std::vector<std::size_t>{line};
           }},
          {"colder amid the print",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64& random) {
             const std::size_t line = insideBead(t, s, random);
             insertBefore(t, line, "M104 S" + std::to_string(20 + random() % 150));
             return std::vector<std::size_t>{line};
           }},
          {"the wait behind the first bead",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64& random) {
             eraseAll(t, "M109");
             insertBefore(t, insideBead(t, s, random), "M109 S210");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"off before the prime",
           [](ProgramText& t, const test::Scene&, std::mt19937_64&) {
             const std::size_t line = lineWith(t, "M109") + 1;
             insertBefore(t, line, "M104 S0");
             return std::vector<std::size_t>{line};
           }},
          {"a cold bed",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64&) {
             eraseAll(t, "M140 S60");
             eraseAll(t, "M190");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"no wait for the bed",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64&) {
             eraseAll(t, "M190");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"a lukewarm bed", [](ProgramText& t, const test::Scene&, std::mt19937_64& random) {
             const std::size_t line = lineWith(t, "M190");
             replaceAll(t, "M190 S60", "M190 S" + std::to_string(random() % 30));
             return std::vector<std::size_t>{line, line + 1};
           }}};
}

std::vector<Edit> textEdits() {
  return {{"no heat",
           [](ProgramText& t, const test::Scene& s, std::mt19937_64&) {
             eraseAll(t, "M210n");
             return std::vector<std::size_t>{firstMotion(t, s)};
           }},
          {"off at the start",
           [](ProgramText& t, const test::Scene&, std::mt19937_64&) {
             const std::size_t line = lineWith(t, "M210n");
             replaceAll(t, "M210n", "M0n");
             return std::vector<std::size_t>{line};
           }},
          {"too cold",
           [](ProgramText& t, const test::Scene&, std::mt19937_64& random) {
             const std::size_t line = lineWith(t, "M210n");
             replaceAll(t, "M210n", "M" + std::to_string(20 + random() % 150) + "n");
             return std::vector<std::size_t>{line};
           }},
          {"off amid the print", [](ProgramText& t, const test::Scene& s, std::mt19937_64& random) {
             const std::size_t line = insideBead(t, s, random);
             std::string heat = t.lines[lineWith(t, "M210n") - 1];
             heat.replace(heat.find("M210n"), 5, "M0n");
             insertBefore(t, line, heat);
             return std::vector<std::size_t>{line};
           }}};
}

void expectAllRefused(const std::string& format, const std::vector<Edit>& edits, int seeds) {
  const ProgramText whole = write(scene(), format);
  const Verification sound = verify(scene(), whole);
  ASSERT_TRUE(sound.passed) << findingsText(sound);
  EXPECT_TRUE(std::ranges::none_of(sound.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::FanChanged;
  })) << findingsText(sound);
  for (const Edit& edit : edits)
    for (int seed = 0; seed < seeds; ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      ProgramText text = whole;
      const std::vector<std::size_t> lines = edit.apply(text, scene(), random);
      const Verification v = verify(scene(), text);
      EXPECT_FALSE(v.passed) << format << ": " << edit.name;
      EXPECT_TRUE(std::ranges::any_of(
          v.places,
          [&](TextPlace place) { return std::ranges::find(lines, place.line) != lines.end(); }))
          << format << ": " << edit.name << " at line " << lines.front() << "\n"
          << findingsText(v);
    }
}

TEST(HeatFacts, ExtendedGcodeThatExtrudesColdIsRefused) {
  expectAllRefused("gcode-extended", gcodeEdits(), 2);
}

TEST(HeatFacts, GcodeOfATableThatExtrudesColdIsRefused) {
  expectAllRefused("gcode-bc", gcodeEdits(), 1);
}

TEST(HeatFacts, TextsThatExtrudeColdAreRefused) {
  expectAllRefused("urscript", textEdits(), 2);
  expectAllRefused("spel", textEdits(), 1);
}

TEST(HeatFacts, OnlyTemperaturesNearTheMaterialsOwnPass) {
  const struct {
    const char *nozzle, *bed;
    bool passes;
  } cases[] = {{"215", "50", true},  {"205", "70", true},  {"216", "60", false},
               {"204", "60", false}, {"225", "60", false}, {"210", "49", false},
               {"210", "71", false}, {"240", "85", false}};
  for (const auto& c : cases) {
    ProgramText text = write(scene(), "gcode-extended");
    replaceAll(text, "M104 S210", std::string("M104 S") + c.nozzle);
    replaceAll(text, "M109 S210", std::string("M109 S") + c.nozzle);
    replaceAll(text, "M140 S60", std::string("M140 S") + c.bed);
    replaceAll(text, "M190 S60", std::string("M190 S") + c.bed);
    const Verification v = verify(scene(), text);
    EXPECT_EQ(v.passed, c.passes) << c.nozzle << ", " << c.bed << "\n" << findingsText(v);
  }
}

TEST(HeatFacts, AMaterialWithoutTemperaturesNeedsNone) {
  test::Scene s = scene();
  s.process.material = process::materialNamed("clay");
  s.process.material.densityGPerCm3 = 2.0;
  const ProgramText text = write(s, "gcode-extended");
  EXPECT_EQ(lineWith(text, "M109") + lineWith(text, "M190") + lineWith(text, "M106"), 0u);
  const Verification v = verify(s, text);
  EXPECT_TRUE(v.passed) << findingsText(v);
}

std::vector<std::size_t> fanLines(const Verification& v) {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < v.findings.size(); ++i)
    if (v.findings[i].kind == plan::FindingKind::FanChanged)
      lines.push_back(v.places[i].line);
  return lines;
}

TEST(HeatFacts, TheFanStartsWithTheSecondLayerAndItsLackIsARemark) {
  for (const char* format : {"gcode-extended", "gcode-bc", "urscript"}) {
    SCOPED_TRACE(format);
    const ProgramText whole = write(scene(), format);
    const std::string on = std::string(format) == "urscript" ? "F255n" : "M106 S255";
    const std::size_t line = lineWith(whole, on);
    ASSERT_GT(line, 0u);
    EXPECT_TRUE(fanLines(verify(scene(), whole)).empty());
    ProgramText text = whole;
    text.lines[line - 1] = "";
    Verification v = verify(scene(), text);
    EXPECT_TRUE(v.passed) << findingsText(v);
    ASSERT_EQ(fanLines(v).size(), 1u) << findingsText(v);
    EXPECT_GT(fanLines(v).front(), line);
    // On in the first layer.
    text = whole;
    const plan::ReadProgram read = test::read(text, scene().process);
    insertBefore(text, read.motions.front().line, whole.lines[line - 1]);
    v = verify(scene(), text);
    EXPECT_TRUE(v.passed) << findingsText(v);
    ASSERT_EQ(fanLines(v).size(), 1u) << findingsText(v);
    EXPECT_LT(fanLines(v).front(), line);
  }
}

TEST(HeatFacts, BridgesHaveAFanSpeedOfTheirOwn) {
  test::Scene s = scene();
  s.process.material.fan = 0.4;
  s.process.material.bridgeFan = 1.0;
  s.plan.paths[11].kind = plan::PathKind::Bridge;
  const ProgramText text = write(s, "gcode-extended");
  const std::size_t bridge = lineWith(text, "M106 S255"), other = lineWith(text, "M106 S102");
  ASSERT_GT(bridge, 0u);
  EXPECT_GT(other, bridge);
  EXPECT_TRUE(fanLines(verify(s, text)).empty());
}

// By hand: random statements and motions, judged by a walk over single steps.
TEST(HeatFacts, AgreesWithAWalkOverSingleSteps) {
  const test::Scene& s = scene();
  std::mt19937_64 random(7);
  int refused = 0;
  for (int n = 0; n < 300; ++n) {
    plan::ReadProgram program;
    program.neededFacts = {plan::FactKind::NozzleHeat, plan::FactKind::NozzleHeatWait};
    bool on = false, hot = false, cold = false;
    for (std::size_t step = 0; step < 12; ++step) {
      plan::StatedFact fact;
      fact.before = program.motions.size();
      fact.line = static_cast<std::uint32_t>(step + 1);
      switch (random() % 4) {
      case 0:
        fact.kind = plan::FactKind::NozzleHeat;
        fact.number = random() % 3 == 0 ? 0.0 : 202.0 + static_cast<double>(random() % 14);
        program.facts.push_back(fact);
        on = std::abs(fact.number - *s.process.material.nozzleC) <= kNozzleToleranceC;
        hot = hot && on;
        break;
      case 1:
        fact.kind = plan::FactKind::NozzleHeatWait;
        program.facts.push_back(fact);
        hot = on;
        break;
      default: {
        plan::ProgramMotion motion;
        motion.line = fact.line;
        motion.extruding = random() % 2 == 0;
        cold = cold || (motion.extruding && !hot);
        program.motions.push_back(motion);
      }
      }
    }
    if (program.motions.empty())
      continue;
    const auto found = compareHeat(program, s.trajectory, process::Tooling(s.process));
    EXPECT_EQ(found.empty(), !cold) << n;
    refused += cold;
  }
  EXPECT_GT(refused, 50);
}

} // namespace
} // namespace voluta::replay
