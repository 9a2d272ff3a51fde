// RAPID whose flow follows the TCP's speed (TriggSpeed): the undamaged program passes, whatever the
// speed, and damage to the flow is refused at its line.
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

class FlowBySpeed : public ::testing::Test {
protected:
  void SetUp() override {
    program::ProgramInput in{scene_.plan, scene_.trajectory, scene_.cell,
                             process::Tooling(scene_.process), "box"};
    in.options.own["rapidFlow"] = std::string("speed");
    whole_ = test::textOf(program::writeProgram("rapid", in));
  }
  Verification verify(const test::ProgramText& text) const {
    return replayProgram({test::read(text, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, process::Tooling(scene_.process), scene_.part,
                          scene_.platform},
                         ReplayThresholds{}, {});
  }
  // The first line from `from` on (an index) that the pattern is in.
  std::size_t next(std::size_t from, const std::string& pattern) const {
    const std::regex words(pattern);
    while (from < whole_.lines.size() && !std::regex_search(whole_.lines[from], words))
      ++from;
    return from;
  }

  const test::Scene scene_ = test::boxScene(1);
  test::ProgramText whole_;
};

TEST_F(FlowBySpeed, theUndamagedProgramPasses) {
  const Verification v = verify(whole_);
  EXPECT_TRUE(v.passed && v.findings.empty()) << findingsText(v);
  EXPECT_NEAR(v.massRatio, 1.0, 0.005);
  EXPECT_LT(v.flowErrorFraction, 0.01);
}

TEST_F(FlowBySpeed, harmIsFoundAtItsLine) {
  const std::string scale = "(TriggSpeed tFlow,0\\\\Start,0,aoFlow,)([0-9.]+)";
  const std::pair<std::string, std::string> kinds[] = {
      {scale, "$10.9"},         {scale, "$19$2"},       {scale, "$10.001"},
      {scale, "$1-$2"},         {scale, "$10"},         {"aoFlow,", "aoFan,"},
      {"Start,0,", "Start,1,"}, {"tFlow,0", "tFlow,5"}, {"TriggSpeed", "TriggIO"},
      {"tFlow", "tOther"},      {"TriggSpeed.*;", ""},  {"\\\\Start", ""}};
  // The box has one section, so it is stated once.
  const std::size_t at = next(0, "TriggSpeed tFlow");
  ASSERT_LT(at, whole_.lines.size());
  EXPECT_EQ(next(at + 1, "TriggSpeed tFlow"), whole_.lines.size());
  const auto expectNamed = [&](const test::ProgramText& text, std::size_t line,
                               const std::string& kind) {
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed) << kind;
    EXPECT_TRUE(std::ranges::any_of(
        v.places, [&](TextPlace p) { return p.line >= line && p.line <= line + 3; }))
        << kind << ": " << findingsText(v).substr(0, 200);
  };
  for (const auto& [from, to] : kinds) {
    test::ProgramText text = whole_;
    text.lines[at] = std::regex_replace(text.lines[at], std::regex(from), to);
    ASSERT_NE(text.lines[at], whole_.lines[at]) << from;
    expectNamed(text, at, from + " -> " + to);
  }
  // Within a bead: a share that holds from there on, at any speed.
  const std::size_t bead = next(at + 60, "MoveL.*\\[FALSE");
  for (const char* middle :
       {"    SetAO aoFlow,0.9;\r", "    SetAO aoFlow,0;\r", "    TriggSpeed x;\r"}) {
    test::ProgramText text = whole_;
    text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(bead + 1), middle);
    expectNamed(text, bead + 1, middle);
  }
}

} // namespace
} // namespace voluta::replay
