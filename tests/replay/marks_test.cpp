// Marks in programs of every dialect that has them, and both programs of a pair in one time.
#include "plan/finding_kinds.h"
#include "plan/marks.h"
#include "replay/any_start.h"
#include "replay/event_programs.h"
#include "replay/shared_run.h"
#include "replay/told.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace voluta::replay {
namespace {

constexpr std::size_t kMarks = 6;

// A box of four layers with a start mark, marks in lifted travels, two of them at one place, and
// one at the end.
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
    add(1);
    for (std::size_t k = 0; k + 2 < kMarks; ++k)
      add(travels[k * travels.size() / kMarks]);
    add(t.events.back().point);
    add(t.pointCount());
    ASSERT_EQ(t.events.size(), kMarks + 1);
  }
  void add(std::size_t point) {
    scene_.trajectory.events.push_back({.point = point, .kind = plan::EventKind::Mark});
  }
  void setLink(int link) {
    for (plan::TrajectoryEvent& event : scene_.trajectory.events)
      event.tool = link;
  }
  // Three start marks at the first point, and each mark for another machine in turn.
  void useThreeChannels() {
    std::vector<plan::TrajectoryEvent>& events = scene_.trajectory.events;
    events.insert(events.begin(), 2, events.front());
    for (std::size_t e = 0; e < events.size(); ++e) {
      const int channel = static_cast<int>(e) % plan::kMarkChannels;
      events[e].tool = plan::markLink(channel, channel > 0);
    }
  }
  static std::vector<std::string_view> formats() { return formatsWith(plan::EventKind::Mark); }
  static bool isMark(const plan::StatedFact& fact) {
    return fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited;
  }
  static std::vector<std::size_t> marksIn(const plan::ReadProgram& program) {
    std::vector<std::size_t> marks;
    for (std::size_t f = 0; f < program.facts.size(); ++f)
      if (isMark(program.facts[f]))
        marks.push_back(f);
    return marks;
  }
};

constexpr int kLinks[] = {plan::markLink(0, true), plan::markLink(0, false)};

TEST_F(MarkedPrograms, AreReadBackAndPassInEveryDialect) {
  EXPECT_GE(formats().size(), 5u);
  for (const std::string_view format : formats())
    for (const int link : kLinks) {
      SCOPED_TRACE(std::string(format) + " link " + std::to_string(link));
      setLink(link);
      const plan::ReadProgram read = this->read(test::textOf(programFor(format)));
      EXPECT_TRUE(read.defects.empty())
          << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
      std::vector<std::pair<bool, int>> marks, wanted;
      for (const plan::StatedFact& fact : read.facts)
        if (isMark(fact))
          marks.emplace_back(fact.kind == plan::FactKind::MarkSet, static_cast<int>(fact.number));
      for (const plan::MarkStatement& said : plan::markStatements(scene_.trajectory))
        wanted.emplace_back(said.sets, plan::markCode(said.signal, said.on));
      EXPECT_EQ(marks, wanted);
      const Verification v = verify(read);
      EXPECT_TRUE(v.passed) << findingsText(v);
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

// A statement of a mark left out, doubled, exchanged with the next one, with another value or
// signal, at another motion, or a set that became an await.
TEST_F(MarkedPrograms, EveryEditIsRefused) {
  std::vector<plan::ReadProgram> programs;
  for (const std::string_view format : formats()) {
    for (const int link : kLinks) {
      setLink(link);
      programs.push_back(read(test::textOf(programFor(format))));
    }
  }
  std::mt19937 random(5);
  for (std::size_t which = 0; which < programs.size(); ++which)
    for (int edit = 0; edit < 21; ++edit) {
      plan::ReadProgram program = programs[which];
      setLink(kLinks[which % 2]);
      const std::vector<std::size_t> marks = marksIn(program);
      ASSERT_GT(marks.size(), 4 * kMarks);
      std::size_t m = random() % (marks.size() - 1);
      plan::StatedFact* fact = &program.facts[marks[m]];
      const int kind = edit % 7;
      SCOPED_TRACE(program.format + " edit " + std::to_string(kind) + " of statement " +
                   std::to_string(m));
      const auto isSame = [&](std::size_t a, std::size_t b) {
        const plan::StatedFact &x = program.facts[marks[a]], &y = program.facts[marks[b]];
        return x.kind == y.kind && x.number == y.number && x.before == y.before;
      };
      switch (kind) {
      case 0:
        program.facts.erase(program.facts.begin() + static_cast<std::ptrdiff_t>(marks[m]));
        break;
      case 1:
        program.facts.insert(program.facts.begin() + static_cast<std::ptrdiff_t>(marks[m]),
                             plan::StatedFact(*fact));
        break;
      case 2:
        while (isSame(m, m + 1))
          m = random() % (marks.size() - 1);
        std::swap(program.facts[marks[m]].kind, program.facts[marks[m + 1]].kind);
        std::swap(program.facts[marks[m]].number, program.facts[marks[m + 1]].number);
        if (isSame(m, m + 1))
          continue;
        break;
      case 3:
        fact->number = static_cast<double>(static_cast<int>(fact->number) ^ 1);
        break;
      case 4:
        fact->number =
            static_cast<double>((static_cast<int>(fact->number) + 2) % (2 * plan::kMarkSignals));
        break;
      case 5:
        fact->before = fact->before > 6 ? fact->before - 3 : fact->before + 4;
        break;
      default:
        fact->kind = fact->kind == plan::FactKind::MarkSet ? plan::FactKind::MarkAwaited
                                                           : plan::FactKind::MarkSet;
      }
      const Verification v = verify(std::move(program));
      EXPECT_FALSE(v.passed);
      EXPECT_TRUE(std::ranges::any_of(v.findings, [](const plan::Finding& f) {
        return f.kind == plan::FindingKind::StatementMissing ||
               f.kind == plan::FindingKind::StatementChanged;
      })) << findingsText(v);
    }
}

TEST_F(MarkedPrograms, ADeletedLineIsRefused) {
  for (const std::string_view format : formats())
    for (const int link : kLinks) {
      setLink(link);
      const test::ProgramText text = test::textOf(programFor(format));
      const plan::ReadProgram whole = read(text);
      std::vector<std::size_t> lines;
      for (const std::size_t fact : marksIn(whole))
        lines.push_back(whole.facts[fact].line);
      EXPECT_EQ(lines.size(), plan::markStatements(scene_.trajectory).size()) << format;
      // Those of the start mark and the first two marks, and the last ones.
      for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k > 20 && k + 4 < lines.size())
          continue;
        SCOPED_TRACE(std::string(format) + " line " + std::to_string(lines[k]) + ": " +
                     text.lines[lines[k] - 1]);
        test::ProgramText damaged = text;
        damaged.lines.erase(damaged.lines.begin() + static_cast<std::ptrdiff_t>(lines[k]) - 1);
        EXPECT_FALSE(verify(read(damaged)).passed);
      }
    }
}

// Each mark is for another machine, in turn.
TEST_F(MarkedPrograms, ThreeChannelsPassInEveryDialect) {
  useThreeChannels();
  for (const std::string_view format : formats()) {
    SCOPED_TRACE(format);
    const plan::ReadProgram read = this->read(test::textOf(programFor(format)));
    EXPECT_TRUE(read.defects.empty())
        << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    // Statements of different channels, with each other's signals.
    const std::vector<std::size_t> marks = marksIn(read);
    const auto signalOf = [&](std::size_t m) {
      return plan::markSignalOf(static_cast<int>(read.facts[marks[m]].number));
    };
    for (std::size_t m = 0; m + 1 < marks.size(); ++m)
      if (signalOf(m) / 2 != signalOf(m + 1) / 2) {
        plan::ReadProgram swapped = read;
        std::swap(swapped.facts[marks[m]].number, swapped.facts[marks[m + 1]].number);
        EXPECT_FALSE(verify(swapped).passed) << m;
      }
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

// Motions with marks before some of them, up to the number of motions, behind start marks.
Timed run(std::size_t machine, std::vector<double> seconds, const std::vector<TimedMark>& marks) {
  Timed r{{}, std::move(seconds)};
  r.program.motions.resize(r.seconds.size());
  const auto state = [&](bool sets, std::size_t before, int signal, bool on) {
    plan::StatedFact& fact = r.program.facts.emplace_back();
    fact.kind = sets ? plan::FactKind::MarkSet : plan::FactKind::MarkAwaited;
    fact.before = before;
    fact.number = static_cast<double>(plan::markCode(signal, on));
  };
  const auto mark = [&](int channel, std::size_t before, bool isStart) {
    const bool leads = machine < plan::markPeer(machine, channel);
    for (const plan::MarkStep& step : plan::markSteps(leads, isStart))
      state(step.sets, before, 2 * channel + step.signal, step.on);
  };
  std::vector<int> channels;
  for (const TimedMark& m : marks)
    channels.push_back(m.channel);
  std::ranges::sort(channels);
  channels.erase(std::ranges::unique(channels).begin(), channels.end());
  for (const int channel : channels)
    state(true, 0, 2 * channel, false);
  for (const int channel : channels)
    mark(channel, 0, true);
  for (const TimedMark& m : marks)
    mark(m.channel, m.before, false);
  for (const int channel : channels)
    for (int signal = 0; signal < 2; ++signal)
      state(true, r.seconds.size(), 2 * channel + signal, false);
  return r;
}

// A start mark waits eight times in turn for a signal, a mark four times (plan::markSteps).
constexpr double kStartS = 8.0 * kSignalS, kMarkS = 4.0 * kSignalS;

CommonClock clockOf(const Timed& a, const Timed& b) {
  return commonClock(std::array{&a.program, &b.program}, std::array{a.seconds, b.seconds});
}

TEST(CommonClocks, WaitForTheLaterOne) {
  const Timed a = run(0, {2.0, 3.0, 1.0}, {{1}, {2}}), b = run(1, {5.0, 1.0, 4.0}, {{1}, {2}});
  const CommonClock clock = clockOf(a, b);
  EXPECT_FALSE(clock.stuck);
  EXPECT_NEAR(clock.machines[0].beginS[1], 5.0, kStartS + kMarkS);
  EXPECT_NEAR(clock.machines[1].beginS[2], 8.0, kStartS + 2 * kMarkS);
  EXPECT_NEAR(clock.machines[0].waitS(), 3.0, kStartS + 2 * kMarkS);
  EXPECT_EQ(clock.machines[0].meetings().size(), 2u);
  EXPECT_EQ(clock.machines[0].marks.size(), 3u) << "with the start mark";
}

// Any number of marks at one place: no signal gets lost, and neither machine is a mark ahead.
TEST(CommonClocks, KeepBothTogetherAtEveryMark) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const std::size_t marks = random() % 9;
    const auto one = [&](std::size_t machine) {
      std::vector<double> seconds(1 + random() % 6);
      for (double& s : seconds)
        s = 0.01 * static_cast<double>(random() % 1000);
      std::vector<std::size_t> at(marks);
      for (std::size_t& m : at)
        m = random() % (seconds.size() + 1);
      std::ranges::sort(at);
      return std::pair(run(machine, seconds, std::vector<TimedMark>(at.begin(), at.end())), at);
    };
    const auto [a, aAt] = one(0);
    const auto [b, bAt] = one(1);
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
                kStartS + kMarkS * static_cast<double>(marks) + 1e-9);
  }
}

// The second machine meets the first and then the third; those two never meet.
TEST(CommonClocks, OfThreeWaitForTheirOwnPartnersOnly) {
  const Timed a = run(0, {2.0, 3.0}, {{1, 0}}), b = run(1, {5.0, 1.0, 4.0}, {{1, 0}, {2, 1}}),
              c = run(2, {1.0, 1.0}, {{1, 1}});
  const CommonClock clock = commonClock(std::array{&a.program, &b.program, &c.program},
                                        std::array{a.seconds, b.seconds, c.seconds});
  ASSERT_FALSE(clock.stuck);
  EXPECT_NEAR(clock.machines[0].beginS[1], 5.0, 2 * kStartS + kMarkS);
  EXPECT_NEAR(clock.machines[2].beginS[1], 6.0, 2 * kStartS + 2 * kMarkS);
  const std::vector<PassedMark> meetings = clock.machines[1].meetings();
  ASSERT_EQ(meetings.size(), 2u);
  EXPECT_EQ(meetings[0].other, 0u);
  EXPECT_EQ(meetings[1].other, 2u);
  EXPECT_NEAR(clock.machines[0].waitS(), 3.0, 2 * kStartS + kMarkS);
}

// A ring of three, each of which waits first for the next one.
TEST(CommonClocks, ARingThatWaitsForEachOtherIsStuck) {
  const Timed a = run(0, {1.0, 1.0}, {{1, 0}, {1, 1}}), // second, third
      b = run(1, {1.0, 1.0}, {{1, 1}, {1, 0}}),         // third, first
      c = run(2, {1.0, 1.0}, {{1, 0}, {1, 1}});         // first, second
  const CommonClock clock = commonClock(std::array{&a.program, &b.program, &c.program},
                                        std::array{a.seconds, b.seconds, c.seconds});
  EXPECT_TRUE(clock.stuck);
}

TEST(CommonClocks, AMissingMarkLeavesTheOtherWaiting) {
  const Timed a = run(0, {2.0, 3.0}, {{1}}), b = run(1, {1.0, 1.0}, {});
  const CommonClock clock = clockOf(a, b);
  ASSERT_TRUE(clock.stuck);
  EXPECT_EQ(clock.stuck->machine, 0u);
}

// ---- any start

std::optional<UnsafeStart> unsafeStartOf(const Timed& a, const Timed& b) {
  return unsafeStart(std::array{&a.program, &b.program}, std::array{a.seconds, b.seconds});
}

TEST(AnyStart, EveryStateOfTwoMachinesIsTried) {
  std::set<std::pair<unsigned long, unsigned long>> states;
  std::set<double> delays;
  for (const Start& start : startsOf(2)) {
    states.emplace(start.on[0].to_ulong(), start.on[1].to_ulong());
    delays.insert(start.delayS[0] - start.delayS[1]);
  }
  EXPECT_EQ(states.size(), 16u);
  EXPECT_EQ(*delays.begin(), -600.0);
  EXPECT_EQ(*delays.rbegin(), 600.0);
  for (std::size_t machines = 3; machines <= plan::kMaxMachines; ++machines)
    EXPECT_GE(startsOf(machines).size(), kMaxStates * machines);
}

TEST(AnyStart, OfWholeProgramsIsSafe) {
  const std::vector<TimedMark> marks = {{1}, {1}, {2}, {3}};
  EXPECT_FALSE(unsafeStartOf(run(0, {2.0, 3.0, 1.0}, marks), run(1, {5.0, 1.0, 4.0}, marks)));
  const Timed a = run(0, {2.0, 3.0}, {{1, 0}}), b = run(1, {5.0, 1.0, 4.0}, {{1, 0}, {2, 1}}),
              c = run(2, {1.0, 1.0}, {{1, 1}});
  EXPECT_FALSE(unsafeStart(std::array{&a.program, &b.program, &c.program},
                           std::array{a.seconds, b.seconds, c.seconds}));
}

// Without its start mark a program takes the rest of an earlier run for a mark.
TEST(AnyStart, WithoutStartMarksIsFound) {
  Timed a = run(0, {2.0, 3.0}, {{1}}), b = run(1, {5.0, 1.0}, {{1}});
  for (Timed* timed : {&a, &b}) {
    std::vector<plan::StatedFact>& facts = timed->program.facts;
    const bool leads = timed == &a;
    const auto steps = static_cast<std::ptrdiff_t>(plan::markSteps(leads, true).size());
    facts.erase(facts.begin() + 1, facts.begin() + 1 + steps);
  }
  EXPECT_FALSE(clockOf(a, b).stuck) << "from signals that are off they do";
  const auto found = unsafeStartOf(a, b);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->early);
  EXPECT_TRUE(earlyMark(commonClock(std::array{&a.program, &b.program},
                                    std::array{a.seconds, b.seconds}, found->start)));
}

TEST(AnyStart, AProgramThatWaitsForEverIsFound) {
  const Timed a = run(0, {2.0, 3.0}, {{1}}), b = run(1, {1.0, 1.0}, {});
  const auto found = unsafeStartOf(a, b);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->stuck);
}

} // namespace
} // namespace voluta::replay
