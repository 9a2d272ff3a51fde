// The schedule of two machines against brute force over all sequences of phases.
#include "together/schedule.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>

namespace voluta::together {
namespace {

struct Case {
  Conflicts conflicts;
  std::vector<double> aS, bS;
};

Case randomCase(unsigned seed, double share) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::size_t> count(1, 5);
  std::uniform_real_distribution<double> seconds(0.5, 9.0), dice(0.0, 1.0);
  const std::size_t a = count(random), b = count(random);
  Case c{{a, b, Flags(a, b), Flags(a + 1, b), Flags(a, b + 1)}, {}, {}};
  for (std::size_t i = 0; i < a; ++i)
    c.aS.push_back(seconds(random));
  for (std::size_t j = 0; j < b; ++j)
    c.bS.push_back(seconds(random));
  // A rest is part of both segments beside it: where it conflicts, they do.
  for (std::size_t i = 0; i <= a; ++i)
    for (std::size_t j = 0; j < b; ++j)
      if (dice(random) < 0.3 * share) {
        c.conflicts.aRests.set(i, j);
        if (i < a)
          c.conflicts.moving.set(i, j);
        if (i > 0)
          c.conflicts.moving.set(i - 1, j);
      }
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j <= b; ++j)
      if (dice(random) < 0.3 * share) {
        c.conflicts.bRests.set(i, j);
        if (j < b)
          c.conflicts.moving.set(i, j);
        if (j > 0)
          c.conflicts.moving.set(i, j - 1);
      }
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j)
      if (dice(random) < share)
        c.conflicts.moving.set(i, j);
  return c;
}

bool haveNoConflict(const Conflicts& c, const Phase& p) {
  if (p.aFrom == p.aTo)
    for (std::size_t j = p.bFrom; j < p.bTo; ++j)
      if (c.aRests.at(p.aFrom, j))
        return false;
  if (p.bFrom == p.bTo)
    for (std::size_t i = p.aFrom; i < p.aTo; ++i)
      if (c.bRests.at(i, p.bFrom))
        return false;
  for (std::size_t i = p.aFrom; i < p.aTo; ++i)
    for (std::size_t j = p.bFrom; j < p.bTo; ++j)
      if (c.moving.at(i, j))
        return false;
  return true;
}

double sum(const std::vector<double>& seconds, std::size_t from, std::size_t to) {
  double all = 0.0;
  for (std::size_t i = from; i < to; ++i)
    all += seconds[i];
  return all;
}

// Tries every next phase from every pair of rests.
class BruteForce {
public:
  BruteForce(const Case& c, double markS) : c_(c), markS_(markS) {}
  double minimumFrom(std::size_t i, std::size_t j) {
    if (i == c_.conflicts.a && j == c_.conflicts.b)
      return 0.0;
    const auto known = known_.find({i, j});
    if (known != known_.end())
      return known->second;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t m = i; m <= c_.conflicts.a; ++m)
      for (std::size_t n = j; n <= c_.conflicts.b; ++n)
        if ((m > i || n > j) && haveNoConflict(c_.conflicts, {i, m, j, n}))
          minimum = std::min(minimum, std::max(sum(c_.aS, i, m), sum(c_.bS, j, n)) + markS_ +
                                          minimumFrom(m, n));
    return known_[{i, j}] = minimum;
  }

private:
  const Case& c_;
  double markS_;
  std::map<std::pair<std::size_t, std::size_t>, double> known_;
};

TEST(Schedule, IsTheBestOfAll) {
  std::size_t possible = 0, impossible = 0;
  for (unsigned seed = 0; seed < 900; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = randomCase(seed, 0.1 * static_cast<double>(seed % 9));
    const double markS = seed % 2 ? 1.0 : 0.25;
    const auto schedule = fastestSchedule(c.conflicts, c.aS, c.bS, markS);
    const double minimum = BruteForce(c, markS).minimumFrom(0, 0);
    ASSERT_EQ(schedule.has_value(), minimum < std::numeric_limits<double>::infinity());
    (schedule ? possible : impossible) += 1;
    if (!schedule)
      continue;
    std::size_t i = 0, j = 0;
    double seconds = 0.0;
    for (const Phase& p : schedule->phases) {
      EXPECT_EQ(p.aFrom, i);
      EXPECT_EQ(p.bFrom, j);
      EXPECT_TRUE(haveNoConflict(c.conflicts, p));
      seconds += std::max(sum(c.aS, p.aFrom, p.aTo), sum(c.bS, p.bFrom, p.bTo));
      i = p.aTo;
      j = p.bTo;
    }
    EXPECT_EQ(i, c.conflicts.a);
    EXPECT_EQ(j, c.conflicts.b);
    EXPECT_NEAR(schedule->seconds, seconds, 1e-9);
    EXPECT_NEAR(seconds + markS * static_cast<double>(schedule->phases.size()), minimum, 1e-9);
  }
  EXPECT_GT(possible, 300u);
  EXPECT_GT(impossible, 50u);
}

TEST(Schedule, WithoutConflictsNeedsNoMark) {
  const Conflicts none{3, 2, Flags(3, 2), Flags(4, 2), Flags(3, 3)};
  const std::vector<double> aS = {1.0, 2.0, 3.0}, bS = {4.0, 5.0};
  const auto schedule = fastestSchedule(none, aS, bS, 1.0);
  ASSERT_TRUE(schedule);
  EXPECT_EQ(schedule->marks(), 0u);
  EXPECT_DOUBLE_EQ(schedule->seconds, 9.0);
}

// Both pass the same place in the middle of their work: one waits before it, or they swap halves.
TEST(Schedule, ASharedPlaceCostsAtMostItsTime) {
  Conflicts c{3, 3, Flags(3, 3), Flags(4, 3), Flags(3, 4)};
  c.moving.set(1, 1);
  const std::vector<double> seconds = {10.0, 4.0, 10.0};
  const auto schedule = fastestSchedule(c, seconds, seconds, 0.0);
  ASSERT_TRUE(schedule);
  EXPECT_DOUBLE_EQ(schedule->seconds, 28.0);
  EXPECT_LE(schedule->marks(), 2u);
}

TEST(Schedule, FindsTheFurthestSegmentsOfBoth) {
  Conflicts c{3, 3, Flags(3, 3), Flags(4, 3), Flags(3, 4)};
  c.moving.set(0, 2);
  c.moving.set(1, 2);
  for (std::size_t i = 0; i < 4; ++i)
    c.aRests.set(i, 2);
  for (std::size_t j = 0; j < 4; ++j)
    c.bRests.set(1, j);
  c.moving.set(1, 0);
  c.moving.set(1, 1);
  EXPECT_FALSE(fastestSchedule(c, std::vector<double>(3, 1.0), std::vector<double>(3, 1.0), 0.0));
  EXPECT_EQ(furthestReached(c), std::pair(std::size_t{1}, std::size_t{2}));
}

} // namespace
} // namespace voluta::together
