// The way from the machine's reference run to the start: every motion before the first planned one
// is held against the plan, in every kind of G-code.
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

class Approach : public ::testing::TestWithParam<std::string> {
protected:
  static const test::Scene& scene() {
    static const test::Scene one = test::boxScene(1);
    return one;
  }
  void SetUp() override {
    const test::Scene& s = scene();
    whole_ = test::textOf(program::writeProgram(
        GetParam(), {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"}));
    const Verification sound = verify(whole_);
    ASSERT_TRUE(sound.passed) << findingsText(sound);
    first_ = test::read(whole_, s.process).motions.front().line;
  }
  Verification verify(const test::ProgramText& text) const {
    const test::Scene& s = scene();
    return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                          process::Tooling(s.process), s.part, s.platform},
                         ReplayThresholds{}, {});
  }
  // At that line, or at the first motion.
  void expectRefused(const test::ProgramText& text, std::size_t line) const {
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::ranges::any_of(v.places, [&](const TextPlace& place) {
      return place.line == line || (place.line >= first_ - 1 && place.line <= first_ + 1);
    })) << findingsText(v);
  }
  // In the line of the head that the pattern is in.
  void changed(const std::string& pattern, const std::string& by, bool isHarmful = true) const {
    const std::regex expression(pattern);
    test::ProgramText text = whole_;
    for (std::size_t l = 1; l <= first_; ++l)
      if (std::string& line = text.lines[l - 1]; std::regex_search(line, expression)) {
        line = std::regex_replace(line, expression, by);
        SCOPED_TRACE(GetParam() + ": " + whole_.lines[l - 1] + " -> " + line);
        if (isHarmful)
          expectRefused(text, l);
        else
          EXPECT_TRUE(verify(text).passed) << findingsText(verify(text));
        return;
      }
    ADD_FAILURE() << pattern << " is in no line";
  }
  void erased(const std::string& pattern) const {
    const std::regex expression(pattern);
    test::ProgramText text = whole_;
    for (std::size_t l = 1; l < first_; ++l)
      if (std::regex_search(text.lines[l - 1], expression)) {
        SCOPED_TRACE(GetParam() + " without " + text.lines[l - 1]);
        text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(l) - 1);
        return expectRefused(text, l);
      }
    ADD_FAILURE() << pattern << " is in no line";
  }
  // A run that was stopped leaves G93: the first lines would be read as times.
  void withoutUnitOfSpeed() const {
    test::ProgramText text = whole_;
    text.lines.erase(std::ranges::find(text.lines, "G94"));
    const Verification v = verify(text);
    EXPECT_FALSE(v.passed);
    EXPECT_NE(findingsText(v).find("G94 is missing"), std::string::npos) << findingsText(v);
  }
  void inserted(const std::string& line, std::size_t before) const {
    SCOPED_TRACE(GetParam() + " with " + line + " before line " + std::to_string(before));
    test::ProgramText text = whole_;
    text.lines.insert(text.lines.begin() + static_cast<std::ptrdiff_t>(before) - 1, line);
    expectRefused(text, before);
  }

  test::ProgramText whole_;
  std::size_t first_ = 0; // line of the first motion
};

TEST_P(Approach, AndEveryOtherUnplannedMotionIsRefused) {
  changed("^G28$", "G28 X Y");
  changed("^G28$", "G28 X100 Y100 Z0.2");
  changed(" F[0-9.]+$", " F900000"); // of the first line with a speed, the prime excepted
  for (const char* low : {"G1 Z-5 F600", "G0 X10 Y10 Z-5 F600", "G0 Z-0.5 F600"})
    inserted(low, first_);
  // Behind the last motion, and behind G94.
  const std::size_t end = test::read(whole_, scene().process).motions.back().line + 2;
  for (const char* more : {"G0 Z-5 F600", "G0 X0 Y0 F600", "G28"})
    inserted(more, end);
  const bool isTable = GetParam() == "gcode-bc";
  changed("^G28$", "G28 X0 Y0 Z0", isTable); // LinuxCNC would go to that place
  if (isTable)
    withoutUnitOfSpeed();
  if (!isTable) {
    inserted("G0 X40 Y40 F600", first_);
    changed("^G0 X(.*) F[0-9.]+$", "G0 X$1 F60000");
    return;
  }
  changed("^G1 Z([0-9])", "G1 Z-$1");
  changed("^G1 Z[0-9.]+", "G1 Z2.0");
  double plateMm = 0.0; // its rim rises so high while the table turns
  for (const Eigen::Vector2d& corner : scene().platform.polygon)
    plateMm = std::max(plateMm, corner.norm());
  changed("^G1 Z[0-9.]+", "G1 Z" + std::to_string(plateMm - 1.0));
  changed("^G1 Z[0-9.]+", "G1 Z40.0", false); // higher
  changed("^(G1 Z.*) F[0-9.]+", "$1 F60000");
  changed("^(G1 B.*) F[0-9.]+", "$1 F6000");
  changed("^G1 B[-0-9.]+", "G1 B20");
  changed("^(G1 B.*) C[-0-9.]+", "$1 C77");
  changed("^(G1 B.*) C[-0-9.]+", "$1");
  changed("^(G1 X[^B]*) F[0-9.]+$", "$1 F60000");
  changed("^(G1 X[^B]* F)[0-9.]+$", "$01600", false); // slower
  changed("^(G1 X[^B]*)( F[0-9.]+)$", "$1 Z1$2");
  changed("^(G1 X.* B.*) F[0-9.]+$", "$1 F60000");
  for (const char* lost : {"^G1 Z", "^G1 B", "^G1 X[^B]*$", "^G93"})
    erased(lost);
  // Above: up, the table, above the start, G93.
  for (const char* more : {"G28", "G0 Z1 F600"})
    for (std::size_t before = first_ - 3; before <= first_; ++before)
      inserted(more, before);
  inserted("G93", first_ - 3);
  for (const char* more : {"G93", "G1 B30 F600", "G1 C200 F600"})
    inserted(more, first_ - 2);
}

INSTANTIATE_TEST_SUITE_P(Replay, Approach, ::testing::Values("gcode", "gcode-extended", "gcode-bc"),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

} // namespace
} // namespace voluta::replay
