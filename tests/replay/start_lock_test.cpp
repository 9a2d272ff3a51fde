// The tool of a tool changer is locked before the arm moves: in every language, with one tool and
// with several, in each file of a program. Whatever lets the tool fall is refused at its line.
#include "replay/changer_cell.h"
#include "replay/event_programs.h"
#include "replay/told.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <optional>

namespace voluta::replay {
namespace {

using plan::FactKind, plan::StatedFact;

bool isLock(const StatedFact& fact) {
  return fact.kind == FactKind::ToolLocked && fact.number > 0.0;
}

class StartLock : public EventPrograms {
protected:
  void SetUp() override {
    scene_ = test::boxScene(1, test::changerCell());
    ASSERT_TRUE(robot::hasChanger(scene_.cell));
  }
  static std::vector<std::string_view> formats() { return formatsWith(plan::EventKind::Lock); }

  // With one tool, and with two of which the first prints.
  template <typename Check> void inEveryLanguage(const Check& check) {
    process::Process other = scene_.process;
    other.id = "other";
    for (const process::Tooling& tooling :
         {process::Tooling(scene_.process), process::Tooling({{scene_.process}, {other}})}) {
      tooling_ = tooling;
      for (const std::string_view format : formats()) {
        SCOPED_TRACE(std::string(format) + (tooling.isOne() ? ", one tool" : ", two tools"));
        const test::ProgramText text = test::textOf(programFor(format));
        const plan::ReadProgram whole = read(text);
        const auto lock = std::ranges::find_if(whole.facts, isLock);
        ASSERT_NE(lock, whole.facts.end());
        check(text, whole, static_cast<std::size_t>(lock - whole.facts.begin()));
      }
    }
  }
  static void expectAt(const Verification& v, std::size_t line) {
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(
        std::ranges::any_of(v.places, [&](const TextPlace& place) { return place.line == line; }))
        << "nothing is told at line " << line << "\n"
        << findingsText(v);
  }
};

TEST_F(StartLock, IsBehindTheQuestionAndBeforeTheFirstMotion) {
  EXPECT_EQ(formats().size(), 6u);
  inEveryLanguage([&](const auto&, const plan::ReadProgram& whole, std::size_t lock) {
    EXPECT_EQ(whole.facts[lock].before, 0u);
    const auto stop = std::ranges::find(whole.facts, FactKind::OperatorStop, &StatedFact::kind);
    ASSERT_NE(stop, whole.facts.end());
    EXPECT_LT(stop->line, whole.facts[lock].line);
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    if (program::findDialect(whole.format).waitsByMotion)
      return;
    ASSERT_FALSE(whole.pauses.empty());
    EXPECT_EQ(whole.pauses[whole.facts[lock].beforePause].before, 0u);
    EXPECT_EQ(whole.pauses[whole.facts[lock].beforePause].durationS, robot::kChangerS);
  });
}

TEST_F(StartLock, IsDemanded) {
  inEveryLanguage([&](const test::ProgramText& text, const plan::ReadProgram& whole,
                      std::size_t lock) {
    const auto at = static_cast<std::ptrdiff_t>(whole.facts[lock].line) - 1;
    const std::size_t motion = whole.motions[0].line;
    test::ProgramText missing = text;
    missing.lines.erase(missing.lines.begin() + at);
    expectAt(verify(read(missing)), motion - 1);

    plan::ReadProgram late = whole;
    StatedFact moved = whole.facts[lock];
    moved.before = 1;
    late.facts.erase(late.facts.begin() + static_cast<std::ptrdiff_t>(lock));
    late.facts.insert(
        std::ranges::find_if(late.facts, [](const StatedFact& f) { return f.before > 0; }), moved);
    expectAt(verify(std::move(late)), motion);

    test::ProgramText other = text;
    std::string& line = other.lines[static_cast<std::size_t>(at)];
    if (const std::size_t locked = line.find("doToolLocked"); locked != std::string::npos)
      line.replace(locked, 12, "doTool4");
    else
      --*std::find_if(line.begin() +
                          static_cast<std::ptrdiff_t>(line.find_first_not_of(" 0123456789")),
                      line.end(), [](char c) { return c >= '4' && c <= '9'; });
    expectAt(verify(read(other)), motion);
  });
}

TEST_F(StartLock, ItsTimePassesAndItStays) {
  inEveryLanguage([&](const auto&, const plan::ReadProgram& whole, std::size_t lock) {
    const std::size_t line = whole.facts[lock].line;
    if (!program::findDialect(whole.format).waitsByMotion) {
      plan::ReadProgram early = whole; // its wait comes before it
      ++early.facts[lock].beforePause;
      expectAt(verify(std::move(early)), line);
    }

    plan::ReadProgram asked = whole; // behind it
    const auto stop = std::ranges::find(asked.facts, FactKind::OperatorStop, &StatedFact::kind);
    std::rotate(stop, asked.facts.begin() + static_cast<std::ptrdiff_t>(lock),
                asked.facts.begin() + static_cast<std::ptrdiff_t>(lock) + 1);
    expectAt(verify(std::move(asked)), line);

    plan::ReadProgram released = whole;
    StatedFact release = whole.facts[lock];
    release.number = 0.0;
    released.facts.insert(released.facts.begin() + static_cast<std::ptrdiff_t>(lock) + 1, release);
    expectAt(verify(std::move(released)), line);
  });
}

TEST_F(StartLock, IsInEachFile) {
  std::size_t languages = 0;
  for (const std::string_view format : formats())
    for (const char* const form : {"node", "port"}) {
      const bool hasForms = format == "urscript";
      if ((!hasForms && form == std::string_view("port")) || format == "tmscript")
        continue;
      SCOPED_TRACE(std::string(format) + " " + form);
      program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"};
      input.options.motionsPerFile = 25;
      if (hasForms)
        input.options.own["urscriptForm"] = std::string(form);
      const auto files = program::writeProgram(format, input).files;
      const plan::ReadProgram whole = program::readProgram(format, files, tooling_);
      EXPECT_TRUE(whole.defects.empty());
      EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
      std::size_t locks = 0;
      for (std::size_t f = 0; f < whole.facts.size(); ++f) {
        const StatedFact& fact = whole.facts[f];
        if (!isLock(fact))
          continue;
        ++locks;
        EXPECT_EQ(fact.file, whole.motions[fact.before].file);
        // Before a file that is started by itself the changer needs its time again.
        if (form == std::string_view("port")) {
          ASSERT_LT(fact.beforePause, whole.pauses.size());
          EXPECT_EQ(whole.pauses[fact.beforePause].before, fact.before);
          EXPECT_EQ(whole.pauses[fact.beforePause].durationS, robot::kChangerS);
        }
        plan::ReadProgram missing = whole;
        missing.facts.erase(missing.facts.begin() + static_cast<std::ptrdiff_t>(f));
        expectAt(verify(std::move(missing)), whole.motions[fact.before].line);
      }
      EXPECT_EQ(locks, whole.motions.back().file - whole.motions.front().file + 1);
      EXPECT_GE(locks, 4u);
      ++languages;
    }
  EXPECT_EQ(languages, 6u);
}

TEST_F(StartLock, RapidListsItsSignal) {
  for (const bool byAxis : {false, true}) {
    program::ProgramInput input{scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"};
    if (byAxis)
      input.options.own["extruder"] = std::string("external-axis");
    const auto files = program::writeProgram("rapid", input).files;
    EXPECT_TRUE(std::ranges::any_of(files, [](const plan::ProgramFile& file) {
      return file.name.ends_with("_EIO.cfg") &&
             file.text.find("\"doToolLocked\"") != std::string::npos;
    }));
  }
}

TEST_F(StartLock, ACellWithoutAChangerHasNone) {
  scene_ = test::boxScene(1, "ur5-moving");
  for (const std::string_view format : formats()) {
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    EXPECT_TRUE(std::ranges::none_of(whole.facts, isLock)) << format;
  }
}

} // namespace
} // namespace voluta::replay
