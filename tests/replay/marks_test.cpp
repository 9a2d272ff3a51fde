// Marks in programs of every dialect that has them, and both programs of a pair in one time.
#include "helpers/all_seeds.h"
#include "plan/finding_kinds.h"
#include "plan/marks.h"
#include "replay/event_programs.h"
#include "replay/shared_run.h"
#include "replay/told.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

constexpr std::size_t kMarks = 6;

// A box of four layers with marks in lifted travels, two of them at one place, and one at the end.
class MarkedPrograms : public EventPrograms {
protected:
  void SetUp() override {
    plan::Trajectory& t = scene_.trajectory;
    std::vector<std::size_t> travels;
    for (std::size_t i = 3; i + 2 < t.pointCount(); ++i)
      if (t.move[i - 1] == plan::MoveKind::Linear && t.move[i] != plan::MoveKind::Print &&
          t.move[i + 1] != plan::MoveKind::Print && t.move[i - 2] == plan::MoveKind::Print)
        travels.push_back(i);
    ASSERT_GE(travels.size(), kMarks);
    for (std::size_t k = 0; k + 2 < kMarks; ++k)
      add(travels[k * travels.size() / kMarks]);
    add(t.events.back().point);
    add(t.pointCount());
    ASSERT_EQ(t.events.size(), kMarks);
  }
  void add(std::size_t point) {
    scene_.trajectory.events.push_back({.point = point, .kind = plan::EventKind::Mark});
  }
  static std::vector<std::string_view> formats() { return formatsWith(plan::EventKind::Mark); }
  static bool isMark(const plan::StatedFact& fact) {
    return fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited;
  }
};

TEST_F(MarkedPrograms, AreReadBackAndPassInEveryDialect) {
  EXPECT_GE(formats().size(), 5u);
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const plan::ReadProgram read = this->read(test::textOf(programFor(format)));
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    std::vector<std::pair<plan::FactKind, int>> marks, wanted;
    for (const plan::StatedFact& fact : read.facts)
      if (isMark(fact) && fact.before > read.firstMotion)
        marks.emplace_back(fact.kind, static_cast<int>(fact.number));
    for (std::size_t number = 1; number <= kMarks; ++number)
      for (const auto kind : {plan::FactKind::MarkSet, plan::FactKind::MarkAwaited})
        wanted.emplace_back(kind, plan::markPlace(0, number));
    EXPECT_EQ(marks, wanted);
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << told(v);
  }
}

TEST_F(MarkedPrograms, OtherDialectsRefuseBeforehand) {
  for (const char* const id : {"gcode", "gcode-extended", "csv"}) {
    const auto refused =
        program::refusal(program::findDialect(id), scene_.cell, {}, &scene_.trajectory);
    ASSERT_TRUE(refused) << id;
    EXPECT_NE(base::english(refused->whole()).find("a mark for the other machine"),
              std::string::npos);
  }
}

// A statement of a mark left out, doubled, with the other value, or at another motion.
TEST_F(MarkedPrograms, EveryEditIsRefused) {
  const std::vector<std::string_view> all = formats();
  std::vector<plan::ReadProgram> programs;
  for (const std::string_view format : all)
    programs.push_back(read(test::textOf(programFor(format))));
  std::mt19937 random(5);
  for (int edit = 0; edit < 40; ++edit) {
    plan::ReadProgram program = programs[random() % programs.size()];
    std::vector<std::size_t> marks;
    for (std::size_t f = 0; f < program.facts.size(); ++f)
      if (isMark(program.facts[f]) && program.facts[f].before > program.firstMotion)
        marks.push_back(f);
    ASSERT_EQ(marks.size(), 2 * kMarks);
    const std::size_t which = random() % (marks.size() - 2); // the last mark has no other motion
    const auto mark = program.facts.begin() + static_cast<std::ptrdiff_t>(marks[which]);
    const int kind = edit % 5;
    SCOPED_TRACE(program.format + " edit " + std::to_string(kind));
    if (kind == 0)
      program.facts.erase(mark);
    else if (kind == 1)
      program.facts.insert(mark, plan::StatedFact(*mark));
    else if (kind == 2)
      mark->number = static_cast<double>((static_cast<int>(mark->number) + 2) % 4);
    else if (kind == 3)
      mark->before -= 3;
    else // the whole mark twice
      for (int k = 0; k < 2; ++k)
        program.facts.insert(program.facts.begin() +
                                 static_cast<std::ptrdiff_t>(marks[which - which % 2]),
                             plan::StatedFact(program.facts[marks[which - which % 2] + 1]));
    const Verification v = verify(std::move(program));
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::StatementMissing ||
             f.kind == plan::FindingKind::StatementChanged;
    })) << told(v);
  }
}

TEST_F(MarkedPrograms, ADeletedLineIsRefused) {
  for (const std::string_view format : formats()) {
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram whole = read(text);
    std::vector<std::size_t> lines;
    for (const plan::StatedFact& fact : whole.facts)
      if (isMark(fact))
        lines.push_back(fact.line);
    EXPECT_EQ(lines.size(), 2 * kMarks + 2) << format;
    // Every third is a signal and a wait in turn.
    for (std::size_t i = 0; i < lines.size(); i += test::ofSeeds(3u, 1u)) {
      const std::size_t line = lines[i];
      SCOPED_TRACE(std::string(format) + " line " + std::to_string(line) + ": " +
                   text.lines[line - 1]);
      test::ProgramText damaged = text;
      damaged.lines.erase(damaged.lines.begin() + static_cast<std::ptrdiff_t>(line) - 1);
      EXPECT_FALSE(verify(read(damaged)).passed);
    }
  }
}

// Each mark is for another machine, in turn.
TEST_F(MarkedPrograms, ThreeChannelsPassInEveryDialect) {
  int channel = 0;
  for (plan::TrajectoryEvent& event : scene_.trajectory.events)
    event.tool = channel++ % plan::kMarkChannels;
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const test::ProgramText text = test::textOf(programFor(format));
    const plan::ReadProgram read = this->read(text);
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << told(v);
    // Two marks of different channels, with each other's signals.
    std::vector<std::size_t> sets;
    for (std::size_t f = 0; f < read.facts.size(); ++f)
      if (read.facts[f].kind == plan::FactKind::MarkSet && read.facts[f].before > read.firstMotion)
        sets.push_back(f);
    ASSERT_EQ(sets.size(), kMarks);
    plan::ReadProgram swapped = read;
    std::swap(swapped.facts[sets[0]].number, swapped.facts[sets[1]].number);
    EXPECT_FALSE(verify(swapped).passed);
  }
}

// ---- the common clock

struct Timed {
  plan::ReadProgram program;
  std::vector<double> seconds;
};

struct TimedMark {
  std::size_t before = 0; // a motion
  int channel = 0;
};

// Motions with marks before some of them, up to the number of motions.
Timed run(std::vector<double> seconds, const std::vector<TimedMark>& marks) {
  Timed r{{}, std::move(seconds)};
  r.program.motions.resize(r.seconds.size());
  std::array<std::size_t, plan::kMarkChannels> numbers{};
  for (const TimedMark& mark : marks) {
    const std::size_t number = ++numbers.at(static_cast<std::size_t>(mark.channel));
    for (const auto kind : {plan::FactKind::MarkSet, plan::FactKind::MarkAwaited}) {
      plan::StatedFact& fact = r.program.facts.emplace_back();
      fact.kind = kind;
      fact.before = mark.before;
      fact.number = static_cast<double>(plan::markPlace(mark.channel, number));
    }
  }
  return r;
}

CommonClock clockOf(const Timed& a, const Timed& b) {
  return commonClock(std::array{&a.program, &b.program}, std::array{a.seconds, b.seconds});
}

TEST(CommonClocks, WaitForTheLaterOne) {
  const Timed a = run({2.0, 3.0, 1.0}, {{1}, {2}}), b = run({5.0, 1.0, 4.0}, {{1}, {2}});
  const CommonClock clock = clockOf(a, b);
  EXPECT_FALSE(clock.stuck);
  EXPECT_NEAR(clock.machines[0].beginS[1], 5.0, 2 * kSignalS);
  EXPECT_NEAR(clock.machines[1].beginS[2], 8.0, 4 * kSignalS);
  EXPECT_NEAR(clock.machines[0].waitS(), 3.0, 4 * kSignalS);
  EXPECT_EQ(clock.machines[0].marks.size(), 2u);
}

// Any number of marks at one place: no signal gets lost, and neither machine is a mark ahead.
TEST(CommonClocks, KeepBothTogetherAtEveryMark) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const std::size_t marks = random() % 9;
    const auto one = [&] {
      std::vector<double> seconds(1 + random() % 6);
      for (double& s : seconds)
        s = 0.01 * static_cast<double>(random() % 1000);
      std::vector<std::size_t> at(marks);
      for (std::size_t& m : at)
        m = random() % (seconds.size() + 1);
      std::ranges::sort(at);
      return std::pair(run(seconds, std::vector<TimedMark>(at.begin(), at.end())), at);
    };
    const auto [a, aAt] = one();
    const auto [b, bAt] = one();
    const CommonClock clock = clockOf(a, b);
    ASSERT_FALSE(clock.stuck);
    // Closed form: between marks the longer of both counts.
    double now = 0.0;
    for (std::size_t k = 0; k <= marks; ++k) {
      const auto part = [&](const Timed& r, const std::vector<std::size_t>& at) {
        const std::size_t from = k == 0 ? 0 : at[k - 1], to = k == marks ? r.seconds.size() : at[k];
        double sum = 0.0;
        for (std::size_t m = from; m < to; ++m)
          sum += r.seconds[m];
        return sum;
      };
      now += std::max(part(a, aAt), part(b, bAt));
    }
    EXPECT_NEAR(std::max(clock.machines[0].totalS, clock.machines[1].totalS), now,
                2.0 * kSignalS * static_cast<double>(marks) + 1e-9);
  }
}

// The second machine meets the first and then the third; those two never meet.
TEST(CommonClocks, OfThreeWaitForTheirOwnPartnersOnly) {
  const Timed a = run({2.0, 3.0}, {{1, 0}}), b = run({5.0, 1.0, 4.0}, {{1, 0}, {2, 1}}),
              c = run({1.0, 1.0}, {{1, 1}});
  const CommonClock clock = commonClock(std::array{&a.program, &b.program, &c.program},
                                        std::array{a.seconds, b.seconds, c.seconds});
  ASSERT_FALSE(clock.stuck);
  EXPECT_NEAR(clock.machines[0].beginS[1], 5.0, 2 * kSignalS);
  EXPECT_NEAR(clock.machines[2].beginS[1], 6.0, 3 * kSignalS);
  ASSERT_EQ(clock.machines[1].marks.size(), 2u);
  EXPECT_EQ(clock.machines[1].marks[0].other, 0u);
  EXPECT_EQ(clock.machines[1].marks[1].other, 2u);
  EXPECT_NEAR(clock.machines[0].waitS(), 3.0, 2 * kSignalS);
}

// A ring of three, each of which waits first for the next one.
TEST(CommonClocks, ARingThatWaitsForEachOtherIsStuck) {
  const Timed a = run({1.0, 1.0}, {{1, 0}, {1, 1}}), // second, third
      b = run({1.0, 1.0}, {{1, 1}, {1, 0}}),         // third, first
      c = run({1.0, 1.0}, {{1, 0}, {1, 1}});         // first, second
  const CommonClock clock = commonClock(std::array{&a.program, &b.program, &c.program},
                                        std::array{a.seconds, b.seconds, c.seconds});
  EXPECT_TRUE(clock.stuck);
}

TEST(CommonClocks, AMissingMarkLeavesTheOtherWaiting) {
  const Timed a = run({2.0, 3.0}, {{1}}), b = run({1.0, 1.0}, {});
  const CommonClock clock = clockOf(a, b);
  ASSERT_TRUE(clock.stuck);
  EXPECT_EQ(clock.stuck->machine, 0u);
}

} // namespace
} // namespace voluta::replay
