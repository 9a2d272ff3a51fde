// The pulse that cuts a tape: on, a wait, off, in step with the motion. Edits of any of its
// statements are refused beside it; harmless ones are not.
#include "replay/event_programs.h"
#include "replay/mutations.h"
#include "replay/told.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <regex>

namespace voluta::replay {
namespace {

using TextLines = std::vector<std::string>;

// The box of one layer; within one of its beads tape is cut.
class CutPulses : public EventPrograms {
protected:
  void SetUp() override {
    scene_ = test::boxScene(1);
    tooling_ = process::Tooling(scene_.process);
    plan::Trajectory& t = scene_.trajectory;
    std::size_t point = t.pointCount() / 2;
    while (t.move[point - 2] != plan::MoveKind::Print || t.move[point] != plan::MoveKind::Print ||
           t.move[point + 2] != plan::MoveKind::Print)
      ++point;
    t.events = {{.point = point, .kind = plan::EventKind::Cut}};
  }
  static std::vector<std::string> formats() {
    std::vector<std::string> ids;
    for (const program::Dialect& dialect : program::dialects())
      if (std::ranges::find(dialect.events, plan::EventKind::Cut) != dialect.events.end())
        ids.emplace_back(dialect.id);
    return ids;
  }
  // The lines of the cut, from 0: all between the motions beside it that are neither remarks nor of
  // the extruder.
  static std::vector<std::size_t> cutLines(const test::ProgramText& text) {
    static const std::regex kCut(
        R"(digital_out\(7|^ *sleep\(0\.2\)|PulseDO|PULSE|^M400|^M42 P1|^G4 P200)");
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < text.lines.size(); ++i)
      if (std::regex_search(text.lines[i], kCut))
        lines.push_back(i);
    // The prime waits as well.
    if (text.format == "urscript")
      lines.erase(lines.begin(), lines.end() - 3);
    return lines;
  }
  Verification verifyText(const test::ProgramText& text) const { return verify(read(text)); }

  void expectRefused(const test::ProgramText& whole, const test::ProgramText& text,
                     const std::string& edit) const {
    const std::vector<std::size_t> cut = cutLines(whole);
    const Verification v = verifyText(text);
    EXPECT_FALSE(v.passed) << text.format << ": " << edit;
    EXPECT_TRUE(std::ranges::any_of(v.places,
                                    [&](TextPlace place) {
                                      constexpr std::size_t kBeside =
                                          4; // lines, up to the next motion
                                      return place.line >= cut.front() &&
                                             place.line <= cut.back() + 1 + kBeside;
                                    }))
        << text.format << ": " << edit << "\n"
        << findingsText(v);
  }
};

TEST_F(CutPulses, LastAndAreDrawnBackInStepWithTheMotion) {
  EXPECT_EQ(formats().size(), 5u);
  for (const std::string& format : formats()) {
    SCOPED_TRACE(format);
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram read = this->read(text);
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    TextLines cut;
    for (const std::size_t line : cutLines(text))
      cut.push_back(text.lines[line]);
    if (format == "urscript")
      EXPECT_EQ(cut, (TextLines{"  set_standard_digital_out(7,True) # cuts", "  sleep(0.2)",
                                "  set_standard_digital_out(7,False)"}));
    else if (format.starts_with("gcode"))
      EXPECT_EQ(cut,
                (TextLines{"M400", "M42 P1 S255 ; cuts the tape", "G4 P200", "M400", "M42 P1 S0"}));
    else
      EXPECT_EQ(cut.size(), 1u);
  }
}

TEST_F(CutPulses, ALineThatIsMissingIsRefused) {
  for (const std::string& format : formats()) {
    const test::ProgramText whole = test::textOf(programFor(format));
    for (const std::size_t line : cutLines(whole)) {
      test::ProgramText text = whole;
      text.lines.erase(text.lines.begin() + static_cast<std::ptrdiff_t>(line));
      expectRefused(whole, text, "without " + whole.lines[line]);
    }
  }
}

TEST_F(CutPulses, LinesInAnotherOrderAreRefused) {
  for (const std::string& format : formats()) {
    const test::ProgramText whole = test::textOf(programFor(format));
    const std::vector<std::size_t> cut = cutLines(whole);
    for (std::size_t a = 0; a < cut.size(); ++a)
      for (std::size_t b = a + 1; b < cut.size(); ++b) {
        if (whole.lines[cut[a]] == whole.lines[cut[b]])
          continue;
        test::ProgramText text = whole;
        std::swap(text.lines[cut[a]], text.lines[cut[b]]);
        expectRefused(whole, text, whole.lines[cut[a]] + " exchanged with " + whole.lines[cut[b]]);
      }
    // The last line comes after the next motion.
    test::ProgramText late = whole;
    const plan::ReadProgram read = this->read(whole);
    std::size_t next = 0;
    for (const plan::ProgramMotion& motion : read.motions)
      if (next == 0 && motion.line > cut.back())
        next = motion.line;
    std::rotate(late.lines.begin() + static_cast<std::ptrdiff_t>(cut.back()),
                late.lines.begin() + static_cast<std::ptrdiff_t>(cut.back()) + 1,
                late.lines.begin() + static_cast<std::ptrdiff_t>(next));
    expectRefused(whole, late, "the last line behind the next motion");
    // All of it twice.
    test::ProgramText twice = whole;
    twice.lines.insert(twice.lines.begin() + static_cast<std::ptrdiff_t>(cut.back()) + 1,
                       whole.lines.begin() + static_cast<std::ptrdiff_t>(cut.front()),
                       whole.lines.begin() + static_cast<std::ptrdiff_t>(cut.back()) + 1);
    expectRefused(whole, twice, "twice");
  }
}

struct Replacement {
  const char *format, *pattern, *by;
};

TEST_F(CutPulses, OtherDurationsAndValuesAreRefused) {
  const Replacement cases[] = {
      {"urscript", R"(sleep\(0\.2\))", "sleep(0)"},
      {"urscript", R"(sleep\(0\.2\))", "sleep(0.01)"},
      {"urscript", R"(sleep\(0\.2\))", "sleep(5)"},
      {"urscript", R"(\(7,True\))", "(7,False)"},
      {"urscript", R"(\(7,False\))", "(7,True)"},
      {"urscript", R"(\(7,False\))", "(6,False)"},
      {"gcode", "G4 P200", "G4 P0"},
      {"gcode", "G4 P200", "G4 P10"},
      {"gcode", "G4 P200", "G4 P5000"},
      {"gcode", "S255", "S0"},
      {"gcode", "S255", "S20"},
      {"gcode", "P1 S255", "P1"},
      {"gcode", "P1 S0", "P1 S255"},
      {"gcode", "P1 S0", "P2 S0"},
      {"rapid", "PLength:=0.2", "PLength:=20"},
      {"rapid", "PLength:=0.2", "PLength:=0.001"},
      {"rapid", "PulseDO.*", "SetDO doCut,1;"},
      {"krl", "TRUE,0.2", "TRUE,20"},
      {"krl", "TRUE,0.2", "TRUE,0.001"},
      {"krl", "TRUE,0.2", "FALSE,0.2"},
      {"krl", "PULSE.*", "$$OUT[16]=TRUE"},
  };
  for (const std::string& format : formats())
    for (const Replacement& c : cases) {
      if (!format.starts_with(c.format))
        continue;
      const test::ProgramText whole = test::textOf(programFor(format));
      test::ProgramText text = whole;
      for (const std::size_t line : cutLines(whole))
        text.lines[line] =
            std::regex_replace(text.lines[line], std::regex(c.pattern), std::string(c.by));
      ASSERT_NE(text.lines, whole.lines) << c.pattern;
      expectRefused(whole, text, std::string(c.pattern) + " by " + c.by);
    }
}

TEST_F(CutPulses, HarmlessEditsPass) {
  const Replacement cases[] = {
      {"urscript", R"(sleep\(0\.2\))", "sleep(0.3)"},
      {"urscript", R"(set_standard_digital_out\(7)", "set_digital_out(7"},
      {"urscript", " # cuts", ""},
      {"gcode", "G4 P200", "G4 S0.2"},
      {"gcode", "G4 P200", "; a remark\nG4 P250"},
      {"gcode", "M400", "M400\nM400"},
      {"rapid", "PLength:=0.2", "PLength:=0.3"},
      {"rapid", R"(PulseDO\\PLength:=0.2)", R"(PulseDO\High\PLength:=0.2)"},
      {"krl", "TRUE,0.2", "TRUE , 0.30"},
  };
  for (const std::string& format : formats()) {
    const test::ProgramText whole = test::textOf(programFor(format));
    for (const Replacement& c : cases) {
      if (!format.starts_with(c.format))
        continue;
      test::ProgramText text = whole;
      for (const std::size_t line : cutLines(whole))
        text.lines[line] =
            std::regex_replace(text.lines[line], std::regex(c.pattern), std::string(c.by));
      ASSERT_NE(text.lines, whole.lines) << c.pattern;
      const Verification v = verifyText(text);
      EXPECT_TRUE(v.passed) << format << ": " << c.by << "\n" << findingsText(v);
    }
    std::mt19937_64 random(5);
    const std::vector<test::Mutation> all = test::harmlessMutations(format);
    for (std::size_t i = 0; i < 3 * all.size(); ++i) {
      test::Subject subject{whole, read(whole), scene_.process};
      if (!all[i % all.size()].apply(subject, 0, random))
        continue;
      const Verification v = verifyText(subject.text);
      EXPECT_TRUE(v.passed) << format << ": " << all[i % all.size()].kind << "\n"
                            << findingsText(v);
    }
  }
}

} // namespace
} // namespace voluta::replay
