#include "motion/ladder/ladder.h"

#include "base/units.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace voluta;
using motion::LadderNode;
using motion::Rung;

namespace {

struct Case {
  std::vector<Rung> rungs;
  std::vector<double> startCost;
  std::vector<robot::JointLimits> limits{{-10, 10, 1, 1}, {-10, 10, 1, 1}};
  motion::LadderOptions options;
};

// With a rod, half of the nodes are a step or two of its angle away, and its joint is behind those
// that have limits.
Case randomCase(std::mt19937& engine, bool blocks, bool rod = false) {
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  Case c;
  c.options.samples = 6;
  c.options.window = 1;
  c.rungs.resize(5);
  for (Rung& rung : c.rungs)
    for (int n = 0; n < 6; ++n) {
      LadderNode node;
      node.q.resize(rod ? 3 : 2);
      node.q.head(2) << number(-1, 1), number(-1, 1);
      if (rod) {
        node.offset = static_cast<int>(number(-2, 2));
        node.q[2] = 100 * number(-1, 1);
      }
      node.sample = n;
      node.cost = number(0, 0.3);
      node.blocked = blocks && number(0, 1) < 0.4;
      node.side = static_cast<int>(number(-2, 2));
      rung.push_back(node);
    }
  for (int n = 0; n < 6; ++n)
    c.startCost.push_back(number(0, 1));
  c.options.maxStepRad.assign(5, 0.9);
  return c;
}

// Every sequence of nodes. Returns {rungs reached, cost}.
std::pair<std::size_t, double> exhaustive(const Case& c) {
  std::size_t reached = 0;
  double best = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> chosen;
  const std::function<void(double)> go = [&](double cost) {
    if (chosen.size() > reached || (chosen.size() == reached && cost < best)) {
      reached = chosen.size();
      best = cost;
    }
    if (chosen.size() == c.rungs.size())
      return;
    const Rung& rung = c.rungs[chosen.size()];
    for (std::size_t n = 0; n < rung.size(); ++n) {
      if (rung[n].blocked)
        continue;
      double add = rung[n].cost;
      if (chosen.empty()) {
        add += c.startCost[n];
      } else {
        const LadderNode& last = c.rungs[chosen.size() - 1][chosen.back()];
        const int apart = std::abs(last.sample - rung[n].sample);
        const Eigen::VectorXd d = (rung[n].q - last.q).head(2).cwiseAbs();
        if (std::abs(last.offset - rung[n].offset) > 1 || last.side * rung[n].side < 0)
          continue;
        if ((apart != 0 && apart != 1 && apart != 5) || d.maxCoeff() > 0.9)
          continue;
        add += d.sum();
      }
      chosen.push_back(n);
      go(cost + add);
      chosen.pop_back();
    }
  };
  go(0.0);
  return {reached, best};
}

// Starts at the nodes; costs: zero by default.
std::vector<motion::LadderStart> startsOf(const std::vector<Rung>& rungs,
                                          const std::vector<double>& cost = {}) {
  std::vector<motion::LadderStart> starts;
  for (std::size_t n = 0; n < rungs.front().size(); ++n)
    starts.push_back({rungs.front()[n].q, cost.empty() ? 0.0 : cost[n]});
  return starts;
}

} // namespace

TEST(Ladder, AgainstExhaustiveSearch) {
  std::mt19937 engine(5);
  int whole = 0, cut = 0;
  for (int n = 0; n < 400; ++n) {
    const Case c = randomCase(engine, n % 2 == 1, n >= 200);
    const auto [reached, cost] = exhaustive(c);
    const motion::LadderPath path =
        shortestPath(c.rungs, startsOf(c.rungs, c.startCost), c.limits, c.options);
    EXPECT_EQ(path.reached, reached);
    if (reached > 0) {
      EXPECT_NEAR(path.cost, cost, 1e-12);
      EXPECT_EQ(path.node.size(), reached);
    }
    (reached == c.rungs.size() ? whole : cut)++;
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(cut, 5);
}

// Many more nodes a rung than a first look takes, over whole turns of a joint: as Bellman's sweep
// over all of them has it.
TEST(Ladder, ManyNodesAreSweptAsOneByOne) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::mt19937 engine(23);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  int whole = 0, cut = 0;
  for (int n = 0; n < 60; ++n) {
    motion::LadderOptions options;
    options.samples = 8;
    const double spread = n % 3 == 0 ? 3.0 : 1.0; // far apart some rungs cannot be joined
    const std::vector<robot::JointLimits> limits(3, {-40, 40, 1, 1});
    std::vector<Rung> rungs(12);
    for (Rung& rung : rungs)
      for (int k = 0; k < (n % 3 == 0 ? 20 : 120); ++k) {
        LadderNode node;
        node.q.resize(3);
        for (double& q : node.q)
          q = std::remainder(base::kPi + number(-spread, spread), base::kTwoPi);
        node.sample = k % options.samples;
        node.cost = number(0, 1) < 0.2 ? number(0, 3) : 0.0;
        node.blocked = number(0, 1) < 0.2;
        rung.push_back(node);
      }
    options.maxStepRad.assign(rungs.size(), 0.7);
    std::vector<double> startCost;
    for (std::size_t k = 0; k < rungs.front().size(); ++k)
      startCost.push_back(number(0, 4));

    std::size_t reached = 0;
    double minimum = kNone;
    std::vector<double> before;
    for (std::size_t r = 0; r < rungs.size(); ++r) {
      std::vector<double> cost(rungs[r].size(), kNone);
      for (std::size_t k = 0; k < cost.size(); ++k) {
        const LadderNode& node = rungs[r][k];
        if (node.blocked)
          continue;
        if (r == 0)
          cost[k] = startCost[k] + node.cost;
        for (std::size_t m = 0; m < before.size(); ++m) {
          const LadderNode& last = rungs[r - 1][m];
          const int apart = std::abs(last.sample - node.sample);
          Eigen::VectorXd d = node.q - last.q;
          for (double& revolution : d)
            revolution = std::abs(std::remainder(revolution, base::kTwoPi));
          if (std::min(apart, options.samples - apart) <= options.window && d.maxCoeff() <= 0.7)
            cost[k] = std::min(cost[k], before[m] + d.sum() + node.cost);
        }
      }
      const double cheapest = *std::ranges::min_element(cost);
      if (cheapest == kNone)
        break;
      reached = r + 1;
      minimum = cheapest;
      before = cost;
    }
    const auto path = shortestPath(rungs, startsOf(rungs, startCost), limits, options);
    ASSERT_EQ(path.reached, reached);
    EXPECT_NEAR(path.cost, minimum, 1e-9);
    (reached == rungs.size() ? whole : cut)++;
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(cut, 3);
}

// External joints that have to be at their place cost nothing, however far they move.
TEST(Ladder, RodIsNoStepOfTheArms) {
  std::vector<Rung> rungs;
  for (int r = 0; r < 5; ++r) {
    LadderNode node;
    node.q.resize(2);
    node.q << 0.1 * r, 40.0 * r;
    rungs.push_back({node});
  }
  motion::LadderOptions options;
  options.maxStepRad.assign(rungs.size(), 0.2);
  const auto path = shortestPath(rungs, startsOf(rungs), {{-1, 1, 1, 1}}, options);
  ASSERT_EQ(path.reached, 5u);
  EXPECT_NEAR(path.cost, 0.4, 1e-12);
  EXPECT_EQ(path.q.back()[1], 160.0);
}

// A slide counts as robot::asAngle has it, and never by whole turns.
TEST(Ladder, SlidingJointsAreNotWrapped) {
  const double revolution = 2 * base::kPi;
  const std::vector<robot::JointLimits> slide{{-150, 0, 1, 1, robot::JointKind::Sliding}};
  const auto pathTo = [&](double mm) {
    LadderNode from, to;
    from.q.resize(1);
    to.q.resize(1);
    from.q << -20.0;
    to.q << -20.0 + mm;
    motion::LadderOptions options;
    options.maxStepRad.assign(2, 0.05); // 5 mm
    return shortestPath({{from}, {to}}, {{from.q, 0.0}}, slide, options);
  };
  EXPECT_EQ(pathTo(revolution).reached, 1u);
  const auto path = pathTo(4.0);
  ASSERT_EQ(path.reached, 2u);
  EXPECT_NEAR(path.cost, 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(path.q.back()[0], -16.0);
}

// A joint that turns on and on is followed over +-180 degrees, and not beyond its limit.
TEST(Ladder, TurnsAreFollowedUpToTheLimit) {
  std::vector<Rung> rungs;
  for (int r = 0; r < 20; ++r) {
    LadderNode node;
    node.q.resize(1);
    const double angle = 0.5 * r;
    node.q << std::remainder(angle, 2 * base::kPi);
    rungs.push_back({node});
  }
  motion::LadderOptions options;
  options.maxStepRad.assign(rungs.size(), 0.6);
  const std::vector<robot::JointLimits> wide{{-20, 20, 1, 1}}, narrow{{-6, 6, 1, 1}};
  const auto all = shortestPath(rungs, startsOf(rungs), wide, options);
  ASSERT_EQ(all.reached, rungs.size());
  for (std::size_t r = 0; r < rungs.size(); ++r)
    EXPECT_NEAR(all.q[r][0], 0.5 * static_cast<double>(r), 1e-12);
  EXPECT_EQ(shortestPath(rungs, startsOf(rungs), narrow, options).reached,
            13u); // 6 rad at the 13th
}
