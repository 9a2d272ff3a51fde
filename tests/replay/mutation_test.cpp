// Programs that somebody changed: of each dialect at least 40 kinds of harmful edits, found at
// their line, and harmless ones that bring no alarm.
#include "helpers/all_seeds.h"
#include "program/dialect.h"
#include "replay/mutations.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

constexpr std::size_t kMinKinds = 40;

const test::Scene& sceneFor(const std::string& format) {
  static const test::Scene usual = test::boxScene(1), other = test::boxScene(1, "rv2f-moving");
  return test::cellFor(format) == usual.cell.id() ? usual : other;
}

class Mutants : public ::testing::TestWithParam<std::string> {
protected:
  const test::Scene& scene() const { return sceneFor(GetParam()); }
  void SetUp() override {
    const test::Scene& s = scene();
    whole_ = test::textOf(program::writeProgram(
        GetParam(), {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"}));
    read_ = test::read(whole_, s.process);
    const Verification sound = verify(whole_);
    ASSERT_TRUE(sound.passed) << findingsText(sound);
  }
  test::Subject subject() const { return {whole_, read_, scene().process}; }

  Verification verify(const test::ProgramText& text) const {
    const test::Scene& s = scene();
    return replayProgram({test::read(text, s.process), s.plan, s.trajectory, s.cell,
                          process::Tooling(s.process), s.part, s.platform},
                         ReplayThresholds{}, {});
  }

  // Within a bead of the middle of the print: motions from 2 before to 12 behind extrude.
  std::size_t place(std::mt19937_64& random) const {
    for (;;) {
      const std::size_t m = 3 + random() % (read_.motions.size() - 20);
      bool inside = true;
      for (std::size_t k = m - 2; k < m + 5; ++k)
        inside = inside && read_.motions[k].extruding;
      if (inside)
        return m;
    }
  }

  // At the line or the one beside it, or at the first motion behind it where no motion is in
  // between. Damage in the head shows at the first motion that it concerns.
  static bool named(const Verification& v, std::size_t line, const plan::ReadProgram& read) {
    std::size_t next = 0, first = 0;
    for (const plan::ProgramMotion& m : read.motions)
      if (m.line >= line && (next == 0 || m.line < next))
        next = m.line;
    for (const TextPlace p : v.places)
      if (p.line > 0 && (first == 0 || p.line < first))
        first = p.line;
    const bool head = !read.motions.empty() && line < read.motions.front().line;
    return !v.passed &&
           (std::any_of(v.places.begin(), v.places.end(),
                        [&](TextPlace p) {
                          return p.line > 0 &&
                                 ((p.line + 1 >= line && p.line <= line + 1) || p.line == next);
                        }) ||
            (head && first >= line));
  }

  test::ProgramText whole_;
  plan::ReadProgram read_;
};

TEST_P(Mutants, HarmIsFoundAtItsLine) {
  const std::size_t places = test::ofSeeds(1u, 3u); // of each kind
  std::mt19937_64 random(18);
  std::size_t kinds = 0, tried = 0, refused = 0, found = 0;
  std::string missed;
  for (const test::Mutation& mutation : test::harmfulMutations(GetParam())) {
    std::size_t applied = 0;
    for (std::size_t attempt = 0; attempt < 8 * places && applied < places; ++attempt) {
      test::Subject s = subject();
      const std::size_t m = place(random);
      const auto line = mutation.apply(s, m, random);
      if (!line)
        continue;
      ++applied;
      const plan::ReadProgram now = test::read(s.text, s.process);
      const Verification v = verify(s.text);
      refused += v.passed ? 0 : 1;
      const bool here = named(v, *line, now);
      found += here ? 1 : 0;
      if (!here)
        missed += mutation.kind + " (line " + std::to_string(*line) + "): " +
                  (v.passed ? "passed\n" : "elsewhere: " + findingsText(v).substr(0, 160) + "\n");
    }
    kinds += applied > 0 ? 1 : 0;
    tried += applied;
    if (applied == 0)
      missed += "not applied: " + mutation.kind + "\n";
  }
  EXPECT_GE(kinds, kMinKinds);
  EXPECT_EQ(refused, tried) << missed;
  EXPECT_GE(static_cast<double>(found), 0.99 * static_cast<double>(tried)) << missed;
}

TEST_P(Mutants, HarmlessEditsRaiseNoAlarm) {
  const int edits = test::ofSeeds(60, 300);
  std::mt19937_64 random(81);
  const std::vector<test::Mutation> all = test::harmlessMutations(GetParam());
  int alarms = 0, applied = 0;
  std::string reported;
  for (int i = 0; applied < edits && i < 3 * edits; ++i) {
    const test::Mutation& mutation = all[static_cast<std::size_t>(i) % all.size()];
    test::Subject s = subject();
    const auto line = mutation.apply(s, 0, random);
    if (!line)
      continue;
    ++applied;
    const Verification v = verify(s.text);
    if (v.passed && v.findings.empty())
      continue;
    if (++alarms < 5)
      reported += mutation.kind + ": " + s.text.lines[*line - 1] + "\n" + replay::findingsText(v);
  }
  EXPECT_EQ(applied, edits);
  EXPECT_EQ(alarms, 0) << reported;
}

std::vector<std::string> dialectIds() {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : program::dialects())
    ids.emplace_back(dialect.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Replay, Mutants, ::testing::ValuesIn(dialectIds()), [](const auto& i) {
  return std::regex_replace(i.param, std::regex("-"), "_");
});

} // namespace
} // namespace voluta::replay
