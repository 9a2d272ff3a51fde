// Programs for an arm of four axes: offered formats pass, deviations of its controller are found
// and stated in degrees and mm.
#include "base/run_context.h"
#include "base/units.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/executed_path.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(4, "t3");
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

class ScaraProgram : public ::testing::TestWithParam<std::string> {};

TEST_P(ScaraProgram, Passes) {
  const test::ProgramText text = textOf(GetParam());
  const plan::ReadProgram program = test::read(text, scene().process);
  for (const auto& d : program.defects)
    ADD_FAILURE() << d.line << ": " << base::english(d.reason);
  ASSERT_GE(program.motions.size(), scene().trajectory.pointCount());
  const Verification v = verify(text);
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_TRUE(v.findings.empty()) << findingsText(v);
  EXPECT_LT(v.maxDeviationMm, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Dialects, ScaraProgram, ::testing::ValuesIn(test::idsFor("spel")),
                         [](const auto& dialect) {
                           return std::regex_replace(dialect.param, std::regex("-"), "_");
                         });

// The first line from the middle of the text on that has the word.
std::size_t lineWith(const test::ProgramText& text, const std::string& word) {
  for (std::size_t i = text.lines.size() / 2; i < text.lines.size(); ++i)
    if (text.lines[i].find(word) != std::string::npos)
      return i;
  ADD_FAILURE() << word;
  return 0;
}

std::string reportedAfter(const std::string& format, const std::string& word,
                          const std::function<std::string(const std::string&)>& damage) {
  test::ProgramText text = textOf(format);
  const std::size_t i = lineWith(text, word);
  text.lines[i] = damage(text.lines[i]);
  const Verification v = verify(text);
  EXPECT_FALSE(v.passed);
  EXPECT_TRUE(std::any_of(v.places.begin(), v.places.end(), [&](TextPlace p) {
    return p.line == i + 1 || p.line == i + 2;
  })) << findingsText(v);
  return findingsText(v);
}

TEST(ScaraReplay, TheOtherElbowIsFound) {
  const std::string all = reportedAfter("spel", "Move XY", [](std::string line) {
    const std::size_t at =
        line.find(" /R") != std::string::npos ? line.find(" /R") : line.find(" /L");
    line[at + 2] = line[at + 2] == 'R' ? 'L' : 'R';
    return line;
  });
  EXPECT_NE(all.find("change its configuration"), std::string::npos) << all;
}

TEST(ScaraReplay, ATurnOfJoint4IsNoOtherPath) {
  const std::string all = reportedAfter("spel", "Move XY", [](std::string line) {
    const std::size_t end = line.find(')'), begin = line.rfind(',', end) + 1;
    const double u = std::stod(line.substr(begin, end - begin));
    return line.replace(begin, end - begin, std::to_string(u + 20.0));
  });
  EXPECT_NE(all.find("configuration is not the planned one"), std::string::npos) << all;
}

TEST(ScaraReplay, SlideBeyondItsLimitIsGivenInMillimetres) {
  test::ProgramText text = textOf("csv");
  const std::size_t i = lineWith(text, ",print");
  std::vector<std::string> fields;
  std::string rest = text.lines[i];
  for (std::size_t at; (at = rest.find(',')) != std::string::npos; rest = rest.substr(at + 1))
    fields.push_back(rest.substr(0, at));
  fields.push_back(rest);
  fields[3] = "-152.5";
  std::string damaged = fields[0];
  for (std::size_t k = 1; k < fields.size(); ++k)
    damaged += "," + fields[k];
  text.lines[i] = damaged;
  const std::string all = findingsText(verify(text));
  EXPECT_NE(all.find("joint 3 at -152.5 mm, beyond its limit of -150.0"), std::string::npos) << all;
}

// 60 mm in a twentieth of a second, where 1000 mm/s are allowed, looked at every 3 mm: 0.03 rad.
TEST(ScaraReplay, ASlideHasASpeedOfItsOwn) {
  const test::Scene& s = scene();
  plan::ReadProgram program;
  plan::ProgramMotion m;
  m.joints.assign(s.trajectory.at(0), s.trajectory.at(0) + 4);
  m.joints[2] = -100.0;
  m.jointInterpolated = true;
  program.motions.push_back(m);
  m.joints[2] = -40.0;
  m.durationS = 0.05;
  program.motions.push_back(m);
  const auto path = executeProgram(program, s.cell, {});
  EXPECT_EQ(std::count(path.armMotion.begin(), path.armMotion.end(), 1u), 20);
  ASSERT_EQ(path.violations.size(), 1u);
  EXPECT_EQ(path.violations[0].kind, LimitKind::JointSpeed);
  EXPECT_EQ(path.violations[0].joint, 2);
  EXPECT_NEAR(path.violations[0].value, 1200.0, 1e-3);
  EXPECT_EQ(path.violations[0].limit, 1000.0);
  // A joint speed counts a slide by its lever.
  program.motions[1].durationS = 0.0;
  program.motions[1].jointSpeedRadPerS = 0.5;
  EXPECT_NEAR(executeProgram(program, s.cell, {}).durationS[1], 0.6 / 0.5, 1e-12);
}

// As it is written: four numbers a point, the side of the elbow, the slide in mm.
TEST(ScaraReplay, SpelplusHasFourNumbersAPoint) {
  const test::ProgramText text = textOf("spel");
  std::string all;
  for (const std::string& line : text.lines)
    all += line + "\n";
  EXPECT_NE(all.find("TLSet 1, XY(0,0,-130,0)"), std::string::npos) << all.substr(0, 1500);
  EXPECT_EQ(all.find("AutoLJM"), std::string::npos);
  const std::regex number("-?[0-9.]+"), point("XY\\([^,)]*,[^,)]*,[^,)]*,[^,)]*\\) /[RL]");
  std::size_t moves = 0;
  for (const std::string& line : text.lines)
    if (line.find("  Move ") == 0) {
      ++moves;
      EXPECT_TRUE(std::regex_search(line, point)) << line;
    }
  EXPECT_GT(moves, 100u);
  // The joints of the first motion, as its joint table has them.
  const plan::ReadProgram program = test::read(text, scene().process);
  ASSERT_EQ(program.motions.front().joints.size(), 4u);
  EXPECT_NEAR(program.motions.front().joints[2], scene().trajectory.at(0)[2], 1e-5);
  const test::ProgramText table = textOf("csv");
  EXPECT_TRUE(std::any_of(table.lines.begin(), table.lines.end(), [](const std::string& line) {
    return line == "time_s,j1_deg,j2_deg,j3_mm,j4_deg,extruded_mm3,waypoint,move";
  }));
}

} // namespace
} // namespace voluta::replay
