// Programs of several machines, as text, started at any times from any signals, after runs that
// ended and runs that were stopped: no machine moves between other marks than those it meets.
#include "replay/event_programs.h"
#include "together/controllers.h"
#include "together/machine_marks.h"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace voluta::together {
namespace {

using test::Controllers;
using test::Statement;
using test::Statements;

constexpr double kForEver = std::numeric_limits<double>::infinity();

// Random rendezvous, of which each machine has at least one.
Order randomOrder(std::size_t machines, std::size_t rests, std::mt19937& random) {
  Order order;
  std::vector<std::size_t> at(machines, 0);
  const std::size_t count = machines + random() % 8;
  for (std::size_t m = 0; m < count; ++m) {
    std::size_t first = m % machines, second = random() % (machines - 1);
    second += second >= first ? 1 : 0;
    if (first > second)
      std::swap(first, second);
    for (const std::size_t k : {first, second})
      at[k] = std::min(rests - 1, at[k] + random() % 3);
    order.meetings.push_back({first, second, at[first], at[second]});
  }
  return order;
}

class Starts : public replay::EventPrograms {
protected:
  void SetUp() override {
    const plan::Trajectory& t = scene_.trajectory;
    rests_.point = {0};
    for (std::size_t i = 3; i + 2 < t.pointCount(); ++i)
      if (t.move[i - 1] == plan::MoveKind::Linear && t.move[i] != plan::MoveKind::Print &&
          t.move[i + 1] != plan::MoveKind::Print && t.move[i - 2] == plan::MoveKind::Print)
        rests_.point.push_back(i - 1);
    ASSERT_GE(rests_.point.size(), 8u);
    rests_.point.push_back(t.pointCount() - 1);
    unmarked_ = t;
  }
  static std::vector<std::string_view> formats() { return formatsWith(plan::EventKind::Mark); }

  // The written and read programs of a random case.
  std::vector<Statements> programs(std::string_view format, std::size_t machines,
                                   std::mt19937& random) {
    const Order order = randomOrder(machines, rests_.point.size(), random);
    std::vector<Statements> all;
    for (std::size_t k = 0; k < machines; ++k) {
      scene_.trajectory = withMarks(unmarked_, marksOf(order, k, rests_));
      const plan::ReadProgram program = read(test::textOf(programFor(format)));
      EXPECT_TRUE(program.defects.empty()) << base::english(program.defects[0].reason);
      all.push_back(test::statementsOf(program, random));
    }
    return all;
  }

  template <typename Check> void forEachCase(int rounds, const Check& check) {
    unsigned seed = 0;
    for (const std::string_view format : formats())
      for (std::size_t machines = 2; machines <= plan::kMaxMachines; ++machines)
        for (int round = 0; round < rounds; ++round) {
          SCOPED_TRACE(std::string(format) + ", " + std::to_string(machines) + " machines, round " +
                       std::to_string(round));
          std::mt19937 random(++seed);
          check(programs(format, machines, random), random);
          if (HasFatalFailure())
            return;
        }
  }

  Rests rests_;
  plan::Trajectory unmarked_;
};

constexpr double kDelaysS[] = {0.0, 0.1, 2.0, 7.0, 20.0, 130.0, 600.0};

void startAll(Controllers& cell, std::size_t machines, std::mt19937& random) {
  for (std::size_t k = 0; k < machines; ++k)
    cell.start(k, kDelaysS[random() % std::size(kDelaysS)]);
}

void setRandomSignals(Controllers& cell, std::size_t machines, std::mt19937& random) {
  for (std::size_t k = 0; k < machines; ++k)
    cell.setSignals(k, static_cast<unsigned>(random()));
}

TEST_F(Starts, OfTwoKeepTogetherFromEveryStateOfTheSignals) {
  std::size_t runs = 0;
  for (const std::string_view format : formats()) {
    std::mt19937 random(3);
    const std::vector<Statements> two = programs(format, 2, random);
    for (unsigned state = 0; state < 16; ++state)
      for (const double delayS : kDelaysS)
        for (std::size_t late = 0; late < 2; ++late) {
          SCOPED_TRACE(std::string(format) + ", signals " + std::to_string(state) + ", machine " +
                       std::to_string(late + 1) + " " + std::to_string(delayS) + " s later");
          Controllers cell(two, state);
          cell.setSignals(0, state & 3U);
          cell.setSignals(1, state >> 2);
          cell.start(late, delayS);
          cell.start(1 - late, 0.0);
          cell.run(kForEver);
          ASSERT_TRUE(cell.allEnded());
          ASSERT_EQ(cell.conflicts(), 0u);
          ASSERT_TRUE(cell.allOff());
          ++runs;
        }
  }
  EXPECT_GE(runs, 5u * 224u);
}

TEST_F(Starts, KeepTogetherAgainAfterARunThatEnded) {
  forEachCase(6, [](const std::vector<Statements>& programs, std::mt19937& random) {
    Controllers cell(programs, random());
    setRandomSignals(cell, programs.size(), random);
    for (int run = 0; run < 4; ++run) {
      startAll(cell, programs.size(), random);
      cell.run(kForEver);
      ASSERT_TRUE(cell.allEnded());
      ASSERT_EQ(cell.conflicts(), 0u);
      ASSERT_TRUE(cell.allOff());
      cell.stopAll();
    }
  });
}

TEST_F(Starts, KeepTogetherAgainAfterRunsThatWereStopped) {
  forEachCase(6, [](const std::vector<Statements>& programs, std::mt19937& random) {
    Controllers cell(programs, random());
    setRandomSignals(cell, programs.size(), random);
    for (int run = 0; run < 12; ++run) {
      startAll(cell, programs.size(), random);
      cell.run(random() % 3 == 0 ? 0.02 * static_cast<double>(random() % 2000)
                                 : static_cast<double>(random() % 800));
      ASSERT_EQ(cell.conflicts(), 0u);
      cell.stopAll();
    }
    startAll(cell, programs.size(), random);
    cell.run(kForEver);
    ASSERT_TRUE(cell.allEnded());
    ASSERT_EQ(cell.conflicts(), 0u);
  });
}

// The others continue with their old programs up to their last waypoint, and then stop.
TEST_F(Starts, AMachineThatIsRestartedAloneWaitsAtItsFirstPoint) {
  std::size_t restarts = 0;
  forEachCase(12, [&](const std::vector<Statements>& programs, std::mt19937& random) {
    Controllers cell(programs, random());
    startAll(cell, programs.size(), random);
    const std::size_t machines = programs.size(), alone = random() % machines;
    const auto allStarted = [&] {
      for (std::size_t k = 0; k < machines; ++k)
        if (!cell.passedAllStarts(k))
          return false;
      return true;
    };
    for (int step = 0; step < 10000 && !allStarted(); ++step)
      cell.run(0.1);
    ASSERT_TRUE(allStarted());
    cell.run(static_cast<double>(random() % 60));
    if (cell.ended(alone))
      return;
    ++restarts;
    std::vector<std::size_t> reached(machines, 0);
    for (std::size_t k = 0; k < machines; ++k)
      if (k != alone)
        reached[k] = cell.arrived(alone, k);
    cell.ignoreWayToStart(true);
    cell.stop(alone);
    cell.start(alone, 2.0);
    cell.run(kForEver);
    for (std::size_t k = 0; k < machines; ++k)
      if (k != alone) {
        EXPECT_EQ(cell.passed(alone, k), 0u);
        EXPECT_LE(cell.passed(k, alone), reached[k]);
      }
    EXPECT_EQ(cell.conflicts(), 0u);
    // The others are stopped and started then.
    for (std::size_t k = 0; k < machines; ++k)
      if (k != alone) {
        cell.stop(k);
        cell.start(k, kDelaysS[random() % std::size(kDelaysS)]);
      }
    cell.ignoreWayToStart(false);
    cell.run(kForEver);
    ASSERT_TRUE(cell.allEnded());
    ASSERT_EQ(cell.conflicts(), 0u);
  });
  EXPECT_GT(restarts, 100u);
}

// ---- marks without a start mark and without withdrawal at the end, as they would be simplest

// Mark n of a channel on its signal (n - 1) mod 2, in turn on and off; withdrawn at the start.
Statements simplest(const std::vector<MarkPlace>& marks, std::mt19937& random) {
  std::uniform_real_distribution<double> duration(1.0, 20.0);
  Statements all;
  for (int signal = 0; signal < plan::kMarkSignals; ++signal)
    all.push_back({Statement::Kind::Set, 0.0, signal, false});
  std::array<std::size_t, plan::kMarkChannels> numbers{};
  std::size_t point = 0;
  all.push_back({Statement::Kind::Move, duration(random)});
  for (const MarkPlace& mark : marks) {
    if (mark.point > point)
      all.push_back({Statement::Kind::Move, duration(random)});
    point = mark.point;
    const int channel = plan::markChannelOf(mark.link);
    const std::size_t number = numbers.at(static_cast<std::size_t>(channel))++;
    const int signal = 2 * channel + static_cast<int>(number % 2);
    const bool on = number % 4 < 2;
    all.push_back({Statement::Kind::Set, 0.0, signal, on, channel});
    all.push_back({Statement::Kind::Await, 0.0, signal, on, {}, channel});
  }
  all.push_back({Statement::Kind::Move, duration(random)});
  return all;
}

TEST_F(Starts, OfMarksThatAreOnlyWithdrawnAtTheStartDoNotKeepTogether) {
  std::size_t runs = 0, conflicts = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const std::size_t machines = 2 + seed % 3;
    const Order order = randomOrder(machines, rests_.point.size(), random);
    std::vector<Statements> programs;
    for (std::size_t k = 0; k < machines; ++k) {
      std::vector<MarkPlace> marks = marksOf(order, k, rests_);
      std::vector<bool> isStart(plan::kMarkLinks, true);
      std::erase_if(marks, [&](const MarkPlace& mark) {
        const auto link = static_cast<std::size_t>(mark.link);
        const bool erased = isStart[link];
        isStart[link] = false;
        return erased;
      });
      programs.push_back(simplest(marks, random));
    }
    Controllers cell(programs, seed);
    for (std::size_t k = 0; k < machines; ++k)
      cell.start(k, 0.0);
    cell.run(kForEver);
    ASSERT_TRUE(cell.allEnded());
    ASSERT_EQ(cell.conflicts(), 0u) << "from signals that are off, started at once";
    for (int run = 0; run < 5; ++run) {
      const std::size_t before = cell.conflicts();
      cell.stopAll();
      startAll(cell, machines, random);
      cell.run(kForEver);
      ++runs;
      conflicts += cell.conflicts() > before ? 1 : 0;
    }
  }
  EXPECT_GT(conflicts, 10u) << "of " << runs << " further runs";
}

} // namespace
} // namespace voluta::together
