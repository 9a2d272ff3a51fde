// The order of stops, on seeded random stops and against all orders of a few.
#include "toolpath/order/travel.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector3d;

struct Scene {
  std::vector<Stop> stops;
  std::vector<StopGroup> groups;
};

// Open and closed stops, in turns of one to `maximum`.
Scene randomScene(unsigned seed, std::size_t groups, std::size_t maximum, bool closedToo) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-40.0, 40.0), share(0.0, 1.0);
  const auto point = [&](double z) { return Vector3d(at(random), at(random), z); };
  Scene s;
  for (std::size_t t = 0; t < groups; ++t) {
    StopGroup& group = s.groups.emplace_back();
    const auto count = 1 + static_cast<std::size_t>(share(random) * static_cast<double>(maximum));
    for (std::size_t k = 0; k < std::min(maximum, count); ++k) {
      group.push_back(s.stops.size());
      const double z = 0.8 * static_cast<double>(t);
      Stop& stop = s.stops.emplace_back();
      stop.closed = closedToo && share(random) < 0.5;
      if (!stop.closed) {
        stop.ends = {point(z), point(z)};
        continue;
      }
      const Vector3d centre = point(z);
      const int points = 1 + static_cast<int>(share(random) * 30.0);
      for (int i = 0; i < points; ++i)
        stop.ends.emplace_back(centre + 5.0 * Vector3d(std::cos(0.2 * i), std::sin(0.2 * i), 0.0));
    }
  }
  return s;
}

void expectInTurns(const Scene& s, const std::vector<Visit>& visits) {
  ASSERT_EQ(visits.size(), s.stops.size());
  auto next = visits.begin();
  for (const StopGroup& group : s.groups) {
    StopGroup visited;
    for (std::size_t k = 0; k < group.size(); ++k, ++next) {
      ASSERT_LT(next->begin, s.stops[next->stop].ends.size());
      visited.push_back(next->stop);
    }
    std::ranges::sort(visited);
    EXPECT_EQ(visited, group);
  }
}

TEST(Travel, EveryStopOnceInItsTurnAndNeverLongerThanNearestFirst) {
  double nearest = 0.0, shortly = 0.0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Scene s = randomScene(seed, 1 + seed % 7, 1 + seed % 12, true);
    const std::vector<Visit> greedy = visitNearestFirst(s.stops, s.groups, Vector3d::Zero());
    const std::vector<Visit> visits = visitShortly(s.stops, s.groups, Vector3d::Zero());
    expectInTurns(s, greedy);
    expectInTurns(s, visits);
    EXPECT_LE(travelMm(s.stops, visits), travelMm(s.stops, greedy) + 1e-9);
    EXPECT_EQ(visits, visitShortly(s.stops, s.groups, Vector3d::Zero()));
    nearest += travelMm(s.stops, greedy);
    shortly += travelMm(s.stops, visits);
  }
  EXPECT_LT(shortly, 0.85 * nearest);
}

// All orders of up to five stops and all their begins.
double minTravel(const Scene& s) {
  StopGroup order = s.groups.front();
  double minimum = std::numeric_limits<double>::infinity();
  do {
    for (std::size_t bits = 0; bits < std::size_t{1} << order.size(); ++bits) {
      std::vector<Visit> visits;
      for (std::size_t k = 0; k < order.size(); ++k)
        visits.push_back({order[k], bits >> k & 1U});
      minimum = std::min(minimum, travelMm(s.stops, visits));
    }
  } while (std::ranges::next_permutation(order).found);
  return minimum;
}

TEST(Travel, IsNearlyTheMinimumOfAllOrders) {
  int minimum = 0;
  double sum = 0.0, minimumSum = 0.0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Scene s = randomScene(1000 + seed, 1, 5, false);
    const double best = minTravel(s);
    const double made = travelMm(s.stops, visitShortly(s.stops, s.groups, Vector3d::Zero()));
    EXPECT_GE(made, best - 1e-9);
    minimum += made <= best + 1e-9;
    sum += made;
    minimumSum += best;
  }
  EXPECT_GE(minimum, 170);
  EXPECT_LE(sum, 1.03 * minimumSum);
}

// With one stop a turn only the begins are chosen, and they are exact.
TEST(Travel, OrientationsAreTheBestOfAll) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Scene s = randomScene(2000 + seed, 2 + seed % 7, 1, false);
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t bits = 0; bits < std::size_t{1} << s.stops.size(); ++bits) {
      std::vector<Visit> visits;
      for (std::size_t k = 0; k < s.stops.size(); ++k)
        visits.push_back({k, bits >> k & 1U});
      minimum = std::min(minimum, travelMm(s.stops, visits));
    }
    const std::vector<Visit> visits = visitShortly(s.stops, s.groups, Vector3d::Zero());
    EXPECT_NEAR(travelMm(s.stops, visits), minimum, 1e-9);
  }
}

// Circles in a row: from one to the next the travel is the gap between them.
TEST(Travel, CirclesInARowAreVisitedInTurnAcrossTheGaps) {
  constexpr int kCircles = 9, kPoints = 64;
  constexpr double kRadius = 3.0, kPitch = 10.0;
  std::vector<Stop> stops(kCircles);
  std::vector<StopGroup> groups(1);
  for (int c = 0; c < kCircles; ++c) {
    const auto k = static_cast<std::size_t>((5 * c) % kCircles);
    stops[k].closed = true;
    for (int i = 0; i < kPoints; ++i) {
      const double a = 2.0 * std::acos(-1.0) * i / kPoints;
      stops[k].ends.emplace_back(kPitch * c + kRadius * std::cos(a), kRadius * std::sin(a), 0.0);
    }
    groups.front().push_back(static_cast<std::size_t>(c));
  }
  const std::vector<Visit> visits = visitShortly(stops, groups, Vector3d(-20, 0, 0));
  // A closed bead ends where it begins: all but the first and the last circle are crossed.
  const double minimum = (kCircles - 1) * kPitch - 2.0 * kRadius;
  EXPECT_NEAR(travelMm(stops, visits), minimum, 0.01 * minimum);
}

// Five by five points: rows in alternating directions.
TEST(Travel, AGridOfPostsIsVisitedRowByRow) {
  std::vector<Stop> stops;
  std::vector<StopGroup> groups;
  for (int layer = 0; layer < 10; ++layer) {
    StopGroup& group = groups.emplace_back();
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        group.push_back(stops.size());
        stops.push_back({{Vector3d(14.0 * i, 14.0 * j, 0.8 * layer)}, true});
      }
  }
  const std::vector<Visit> visits = visitShortly(stops, groups, Vector3d::Zero());
  EXPECT_LE(travelMm(stops, visits), 1.1 * (10 * 24 * 14.0 + 9 * 0.8));
}

TEST(Travel, OfNothingIsNothing) {
  EXPECT_TRUE(visitShortly({}, {}, Vector3d::Zero()).empty());
  EXPECT_EQ(travelMm({}, {}), 0.0);
  const std::vector<Stop> one{{{Vector3d(3, 4, 0), Vector3d(30, 0, 0)}}};
  const std::vector<StopGroup> groups{{}, {0}, {}};
  const std::vector<Visit> visits = visitShortly(one, groups, Vector3d::Zero());
  EXPECT_EQ(visits, (std::vector<Visit>{{0, 0}}));
  EXPECT_EQ(travelMm(one, visits), 0.0);
  EXPECT_EQ(travelMm(one, visits, Vector3d(0, 0, 0)), 5.0);
}

} // namespace
} // namespace voluta::toolpath
