// The payload that a program states: a controller without it takes that of an earlier program.
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

class Payload : public ::testing::Test {
protected:
  test::ProgramText textFor(const std::string& format) const {
    return test::textOf(program::writeProgram(format, {scene_.plan, scene_.trajectory, scene_.cell,
                                                       process::Tooling(scene_.process), "box"}));
  }
  plan::ReadProgram read(const test::ProgramText& text) const {
    return test::read(text, scene_.process);
  }
  Verification verify(const test::ProgramText& text) const {
    return replayProgram({read(text), scene_.plan, scene_.trajectory, scene_.cell,
                          process::Tooling(scene_.process), scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  }
  static bool isAt(const Verification& v, std::size_t line) {
    return std::ranges::any_of(v.places,
                               [&](const TextPlace& place) { return place.line == line; });
  }

  test::Scene scene_ = test::boxScene(1);
};

TEST_F(Payload, IsNeededWhereALanguageStatesIt) {
  std::size_t formats = 0;
  for (const program::Dialect& dialect : program::dialects()) {
    if (std::ranges::find(dialect.states, plan::FactKind::Payload) == dialect.states.end())
      continue;
    SCOPED_TRACE(dialect.id);
    ++formats;
    const test::ProgramText whole = textFor(std::string(dialect.id));
    const plan::ReadProgram program = read(whole);
    ASSERT_TRUE(program.load);
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    test::ProgramText lost = whole;
    lost.lines.erase(lost.lines.begin() + static_cast<std::ptrdiff_t>(program.load->line) - 1);
    const Verification v = verify(lost);
    EXPECT_FALSE(v.passed);
    // In RAPID and TMscript the line states the tool as well.
    EXPECT_TRUE(isAt(v, program.motions.front().line - 1)) << findingsText(v);
  }
  EXPECT_EQ(formats, 5u);
  test::ProgramText light = textFor("tmscript"); // the tool alone
  for (std::string& line : light.lines)
    line = std::regex_replace(line, std::regex(R"((ChangeTCP\(\{[^}]*\}),[0-9.]+)"), "$1");
  EXPECT_FALSE(verify(light).passed);
}

// A port starts its files one by one: whatever ran between them may have set another one.
TEST_F(Payload, IsNeededInEachFileForAPort) {
  program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell,
                              process::Tooling(scene_.process), "box"};
  input.options.motionsPerFile = 25;
  input.options.own["urscriptForm"] = std::string("port");
  const std::vector<plan::ProgramFile> files = program::writeProgram("urscript", input).files;
  ASSERT_GE(files.size(), 3u);
  const auto verified = [&](const std::vector<plan::ProgramFile>& texts) {
    return replayProgram({program::readProgram("urscript", texts, process::Tooling(scene_.process)),
                          scene_.plan, scene_.trajectory, scene_.cell,
                          process::Tooling(scene_.process), scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  };
  EXPECT_TRUE(verified(files).passed) << findingsText(verified(files));
  for (const std::string statement : {"set_payload(", "set_analog_outputdomain("})
    for (const std::size_t file : {std::size_t{1}, files.size() - 1}) {
      std::vector<plan::ProgramFile> lost = files;
      std::string& text = lost[file].text;
      text.insert(text.find(statement), "# ");
      const Verification v = verified(lost);
      EXPECT_FALSE(v.passed) << statement << file;
      EXPECT_TRUE(std::ranges::any_of(v.places, [&](const TextPlace& place) {
        return place.file == file + 1;
      })) << findingsText(v);
    }
}

TEST_F(Payload, HasItsCentreWhereItIsPlanned) {
  const struct {
    const char *format, *begin, *behind; // of the centre's z
  } cases[] = {{"urscript", R"(set_payload\([^\[]*\[[^\]]*,)", R"(\])"},
               {"rapid", R"(tooldata .*\],\[[0-9.]+,\[[^\]]*,)", R"(\],\[1,0,0,0\],0,0,0)"},
               {"krl", R"(CM \{X [^Z]*Z )", ","},
               {"krl-eki", "^load,[^,]*,[^,]*,[^,]*,", ","}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.format);
    const test::ProgramText whole = textFor(c.format);
    const plan::ReadProgram program = read(whole);
    ASSERT_TRUE(program.load && program.load->centreMm);
    const Eigen::Vector3d planned = scene_.cell.flange_T_moved().translation();
    EXPECT_LT((*program.load->centreMm - planned).norm(), 0.1);
    const std::regex z(std::string("(") + c.begin + ")([0-9.]+)(" + c.behind + ")");
    for (const auto& [by, passes] : {std::pair("$1-$2$3", false), std::pair("$011$2$3", false)}) {
      test::ProgramText text = whole;
      const auto line = std::ranges::find_if(
          text.lines, [&](const std::string& one) { return std::regex_search(one, z); });
      ASSERT_NE(line, text.lines.end());
      *line = std::regex_replace(*line, z, by);
      const Verification v = verify(text);
      EXPECT_EQ(v.passed, passes) << *line;
      EXPECT_TRUE(isAt(v, program.load->line)) << findingsText(v);
    }
  }
}

TEST_F(Payload, OfAReceiverIsNeeded) {
  plan::Program program =
      program::writeProgram("urscript-stream", {scene_.plan, scene_.trajectory, scene_.cell,
                                                process::Tooling(scene_.process), "box"});
  const auto readBack = [&] {
    return program::readProgram("urscript-stream", program.files, process::Tooling(scene_.process));
  };
  const plan::ReadProgram whole = readBack();
  EXPECT_TRUE(whole.defects.empty());
  ASSERT_TRUE(whole.load && whole.load->centreMm);
  std::string& text = program.files[1].text;
  const std::size_t at = text.find("  set_payload(");
  ASSERT_NE(at, std::string::npos);
  text.erase(at, text.find('\n', at) + 1 - at);
  const plan::ReadProgram lost = readBack();
  ASSERT_EQ(lost.defects.size(), 1u);
  EXPECT_EQ(lost.defects[0].file, 1u);
}

} // namespace
} // namespace voluta::replay
