// Orders of work of several machines: safe at any speeds, without deadlock, and how much longer
// they take than the best sequence of phases of all machines.
#include "base/run_context.h"
#include "together/work_order.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>

namespace voluta::together {
namespace {

using Seconds = std::vector<std::vector<double>>;

struct Case {
  PairConflicts conflicts;
  Seconds seconds;
};

// `share`: of the pairs of segments that conflict.
Case randomCase(unsigned seed, std::size_t machines, std::size_t maxSegments, double share) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::size_t> count(1, maxSegments);
  std::uniform_real_distribution<double> duration(0.5, 9.0), dice(0.0, 1.0);
  std::vector<std::size_t> segments;
  Seconds seconds;
  for (std::size_t k = 0; k < machines; ++k) {
    segments.push_back(count(random));
    seconds.emplace_back();
    for (std::size_t s = 0; s < segments.back(); ++s)
      seconds.back().push_back(duration(random));
  }
  Case c{PairConflicts(segments), seconds};
  for (std::size_t j = 1; j < machines; ++j)
    for (std::size_t i = 0; i < j; ++i) {
      Conflicts& t = c.conflicts.of(i, j);
      for (std::size_t a = 0; a < t.a; ++a)
        for (std::size_t b = 0; b < t.b; ++b)
          if (dice(random) < share)
            t.moving.set(a, b);
      // A rest is part of both segments beside it: where it conflicts, they do.
      for (std::size_t a = 0; a <= t.a; ++a)
        for (std::size_t b = 0; b < t.b; ++b)
          if (dice(random) < 0.2 * share) {
            t.aRests.set(a, b);
            if (a < t.a)
              t.moving.set(a, b);
            if (a > 0)
              t.moving.set(a - 1, b);
          }
      for (std::size_t a = 0; a < t.a; ++a)
        for (std::size_t b = 0; b <= t.b; ++b)
          if (dice(random) < 0.2 * share) {
            t.bRests.set(a, b);
            if (b < t.b)
              t.moving.set(a, b);
            if (b > 0)
              t.moving.set(a, b - 1);
          }
    }
  return c;
}

// When each machine begins and ends each of its segments.
struct SegmentTimes {
  std::vector<std::vector<double>> beginS, endS;
  bool ended = true;
};

// Runs all machines with these durations: each on its own, waiting only at its own rendezvous.
SegmentTimes runOf(const Case& c, const Order& order, const Seconds& seconds) {
  const std::size_t machines = seconds.size();
  SegmentTimes run;
  run.beginS.resize(machines);
  run.endS.resize(machines);
  std::vector<double> now(machines, 0.0);
  std::vector<std::vector<Rendezvous>> own(machines);
  for (const Rendezvous& r : order.meetings) {
    own[r.first].push_back(r);
    own[r.second].push_back(r);
  }
  std::vector<std::size_t> next(machines, 0);
  const auto restOf = [&](std::size_t k) {
    const Rendezvous& r = own[k][next[k]];
    return r.first == k ? r.firstRest : r.secondRest;
  };
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t k = 0; k < machines; ++k) {
      const std::size_t to = next[k] < own[k].size() ? restOf(k) : c.conflicts.segments(k);
      while (run.endS[k].size() < to) {
        run.beginS[k].push_back(now[k]);
        now[k] += seconds[k][run.endS[k].size()];
        run.endS[k].push_back(now[k]);
        moved = true;
      }
    }
    for (std::size_t k = 0; k < machines; ++k) {
      if (next[k] == own[k].size())
        continue;
      const Rendezvous r = own[k][next[k]];
      const std::size_t other = r.first == k ? r.second : r.first;
      const auto isSame = [&](const Rendezvous& o) {
        return o.first == r.first && o.second == r.second && o.firstRest == r.firstRest &&
               o.secondRest == r.secondRest;
      };
      if (next[other] == own[other].size() || !isSame(own[other][next[other]]) ||
          run.endS[k].size() != restOf(k) || run.endS[other].size() != restOf(other))
        continue;
      now[k] = now[other] = std::max(now[k], now[other]);
      ++next[k];
      ++next[other];
      moved = true;
    }
  }
  for (std::size_t k = 0; k < machines; ++k)
    run.ended = run.ended && run.endS[k].size() == c.conflicts.segments(k);
  return run;
}

// Returns the number of conflicting segments, or segments and rests, that happen at the same time.
std::size_t meetings(const Case& c, const SegmentTimes& run) {
  constexpr double kSlack = 1e-9;
  const auto overlap = [&](double a, double aEnd, double b, double bEnd) {
    return std::min(aEnd, bEnd) - std::max(a, b) > kSlack;
  };
  std::size_t found = 0;
  for (std::size_t i = 0; i < run.endS.size(); ++i)
    for (std::size_t j = 0; j < run.endS.size(); ++j) {
      if (i == j)
        continue;
      for (std::size_t b = 0; b < run.endS[j].size(); ++b) {
        const double from = run.beginS[j][b], to = run.endS[j][b];
        for (std::size_t a = 0; a < run.endS[i].size(); ++a)
          if (c.conflicts.meet(i, a, j, b) && overlap(run.beginS[i][a], run.endS[i][a], from, to))
            ++found;
        for (std::size_t rest = 0; rest <= run.endS[i].size(); ++rest) {
          const double since = rest == 0 ? 0.0 : run.endS[i][rest - 1];
          const double until = rest == run.endS[i].size() ? std::numeric_limits<double>::infinity()
                                                          : run.beginS[i][rest];
          if (c.conflicts.hinders(i, rest, j, b) && overlap(since, until, from, to))
            ++found;
        }
      }
    }
  return found;
}

// The least time of all sequences of phases in which all machines take part.
class BruteForce {
public:
  explicit BruteForce(const Case& c) : c_(c) {}
  double minimumFrom(const std::vector<std::size_t>& at) {
    const auto known = known_.find(at);
    if (known != known_.end())
      return known->second;
    bool ended = true;
    for (std::size_t k = 0; k < at.size(); ++k)
      ended = ended && at[k] == c_.conflicts.segments(k);
    double minimum = ended ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::vector<std::size_t> to = at; next(at, to);)
      if (isFree(at, to))
        minimum = std::min(minimum, longest(at, to) + minimumFrom(to));
    return known_[at] = minimum;
  }

private:
  // Counts `to` up from `at`; false at the end.
  bool next(const std::vector<std::size_t>& at, std::vector<std::size_t>& to) const {
    for (std::size_t k = 0; k < to.size(); ++k) {
      if (to[k] < c_.conflicts.segments(k))
        return ++to[k], true;
      to[k] = at[k];
    }
    return false;
  }
  bool isFree(const std::vector<std::size_t>& at, const std::vector<std::size_t>& to) const {
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = 0; j < at.size(); ++j)
        for (std::size_t b = at[j]; i != j && b < to[j]; ++b) {
          if (at[i] == to[i] && c_.conflicts.hinders(i, at[i], j, b))
            return false;
          for (std::size_t a = at[i]; a < to[i]; ++a)
            if (c_.conflicts.meet(i, a, j, b))
              return false;
        }
    return true;
  }
  double longest(const std::vector<std::size_t>& at, const std::vector<std::size_t>& to) const {
    double maximum = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      double sum = 0.0;
      for (std::size_t s = at[k]; s < to[k]; ++s)
        sum += c_.seconds[k][s];
      maximum = std::max(maximum, sum);
    }
    return maximum;
  }

  const Case& c_;
  std::map<std::vector<std::size_t>, double> known_;
};

double bruteForce(const Case& c) {
  return BruteForce(c).minimumFrom(std::vector<std::size_t>(c.conflicts.machines(), 0));
}

TEST(Orders, AreSafeAtAnySpeedsAndEnd) {
  std::size_t orders = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t machines = 2 + seed % 3;
    const Case c = randomCase(seed, machines, 12, 0.03 * static_cast<double>(seed % 11));
    const auto order = orderOf(c.conflicts, c.seconds, 0.5, {});
    if (!order)
      continue;
    ++orders;
    const SegmentTimes planned = runOf(c, *order, c.seconds);
    ASSERT_TRUE(planned.ended);
    double last = 0.0;
    for (const std::vector<double>& ends : planned.endS)
      last = std::max(last, ends.back());
    EXPECT_NEAR(order->seconds, last, 1e-9);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> factor(0.05, 4.0);
    for (int speeds = 0; speeds < 5; ++speeds) {
      Seconds other = c.seconds;
      for (auto& own : other)
        for (double& s : own)
          s *= factor(random);
      const SegmentTimes run = runOf(c, *order, speeds == 0 ? c.seconds : other);
      ASSERT_TRUE(run.ended);
      EXPECT_EQ(meetings(c, run), 0u);
    }
  }
  EXPECT_GT(orders, 150u);
}

TEST(Orders, OfTwoMachinesAreOfMinimumTime) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = randomCase(seed, 2, 6, 0.1 * static_cast<double>(seed % 7));
    const auto order = orderOf(c.conflicts, c.seconds, 0.0, {});
    const double minimum = bruteForce(c);
    ASSERT_EQ(order.has_value(), minimum < std::numeric_limits<double>::infinity());
    if (order) {
      EXPECT_NEAR(order->seconds, minimum, 1e-9);
    }
  }
}

// Inserting one machine after another need not find the best; rendezvous of two machines can also
// be better than phases of all.
TEST(Orders, OfMoreMachinesAreCloseToTheBest) {
  std::size_t possible = 0, missed = 0;
  double sum = 0.0, maximum = 0.0, shorter = 0.0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t machines = 3 + seed % 2;
    const Case c =
        randomCase(seed, machines, machines == 3 ? 4 : 3, 0.08 * static_cast<double>(seed % 6));
    const double minimum = bruteForce(c);
    const auto order = orderOf(c.conflicts, c.seconds, 0.0, {});
    if (minimum == std::numeric_limits<double>::infinity()) {
      EXPECT_FALSE(order);
      continue;
    }
    ++possible;
    if (!order) {
      ++missed;
      continue;
    }
    const double ratio = order->seconds / minimum;
    sum += ratio;
    maximum = std::max(maximum, ratio);
    if (ratio < 1.0 - 1e-9)
      shorter += 1.0;
  }
  const double found = static_cast<double>(possible - missed);
  RecordProperty("possible", static_cast<int>(possible));
  RecordProperty("missed", static_cast<int>(missed));
  RecordProperty("meanRatio", std::to_string(sum / found));
  RecordProperty("greatestRatio", std::to_string(maximum));
  RecordProperty("shorterThanPhasesOfAll", static_cast<int>(shorter));
  EXPECT_GT(possible, 150u);
  EXPECT_LE(static_cast<double>(missed), 0.03 * static_cast<double>(possible));
  EXPECT_LE(sum / found, 1.02);
}

// Two pairs that do not know of each other keep no rendezvous across.
TEST(Orders, MachinesFarApartDoNotWaitForEachOther) {
  PairConflicts conflicts({3, 3, 3, 3});
  conflicts.of(0, 1).moving.set(1, 1);
  conflicts.of(2, 3).moving.set(0, 0);
  const Seconds seconds(4, {5.0, 5.0, 5.0});
  const auto order = orderOf(conflicts, seconds, 0.1, {});
  ASSERT_TRUE(order);
  for (const Rendezvous& r : order->meetings)
    EXPECT_TRUE((r.first == 0 && r.second == 1) || (r.first == 2 && r.second == 3));
  EXPECT_LE(order->seconds, 20.0 + 1e-9);
}

} // namespace
} // namespace voluta::together
