// Unsupported beads, pressed against those beside them.
#include "collision/growing_part.h"
#include "toolpath/options.h"
#include "toolpath/unsupported/tilt_unsupported.h"

#include "base/units.h"
#include "one_pass.h"
#include "plan/finding_kinds.h"
#include "toolpath/nozzle_directions.h"
#include "toolpath/unsupported/bridges.h"
#include "toolpath/unsupported/order_inside_out.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <utility>

using namespace voluta;
using namespace voluta::test;
using Eigen::Vector3d;

namespace {

// Ends under the ledges of these tests, so that nothing can be deposited below them.
const platform::PlatformSolid kNarrowPlate{
    Eigen::Vector2d(-20, -20), {20, -20}, {20, 0.5}, {-20, 0.5}};

collision::GrowingPart grown(const plan::ToolPlan& plan) {
  return {plan, collision::growingPitch(plan, process::Tooling(kProcess)), {}};
}
std::vector<char> unsupportedOf(const plan::ToolPlan& plan, int minPlaces = 1) {
  return toolpath::unsupportedWaypoints(plan, grown(plan), kNarrowPlate, {}, minPlaces);
}
std::vector<std::size_t> orderOf(const plan::ToolPlan& plan) {
  std::vector<std::size_t> order;
  for (const toolpath::OrderedPath& o :
       toolpath::insideOutOrder(plan, unsupportedOf(plan), process::Tooling(kProcess)))
    order.push_back(o.path);
  return order;
}

// A plan of which one direction leans, so that others may.
plan::ToolPlan leaning(plan::ToolPlan plan) {
  plan.direction.front() = Vector3d(0.01, 0.0, 1.0).normalized();
  return plan;
}

// Layer 1 is on a bead of layer 0 and reaches out over it; its beads at these places aside.
plan::ToolPlan ledge(const std::vector<double>& offsets, float height = 0.8f) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  for (const double offset : offsets)
    addPath(plan, -12, 12, offset, 0.8 + static_cast<double>(height), 1, height);
  return leaning(std::move(plan));
}

plan::ToolPlan bracedPlan(const plan::ToolPlan& plan) {
  return afterPass("tilt", plan, kNarrowPlate).plan;
}

double leanDeg(const plan::ToolPlan& before, const plan::ToolPlan& after, std::size_t i) {
  return base::radiansToDegrees(
      std::acos(std::clamp(before.direction[i].dot(after.direction[i]), -1.0, 1.0)));
}

} // namespace

TEST(InwardsFirst, PathsRunFromTheCarriedOneToTheRim) {
  EXPECT_EQ(orderOf(ledge({3.6, 2.4, 0.0, 1.2})), (std::vector<std::size_t>{0, 3, 4, 2, 1}));
  EXPECT_EQ(orderOf(ledge({0.0, 1.2, 2.4})), (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(InwardsFirst, SupportsShortAndUncarriedPathsKeepTheirOrder) {
  // No bead of the layer is carried; supports; beads shorter than half of the bridging length.
  EXPECT_EQ(orderOf(ledge({4.8, 3.6, 2.4})), (std::vector<std::size_t>{0, 1, 2, 3}));
  plan::ToolPlan support = ledge({2.4, 0.0});
  support.paths[1].kind = plan::PathKind::Support;
  EXPECT_EQ(orderOf(support), (std::vector<std::size_t>{0, 1, 2}));
  plan::ToolPlan brief;
  addPath(brief, -15, 15, 0, 0.8, 0);
  addPath(brief, -1.3, 1.3, 2.4, 1.6, 1);
  addPath(brief, -12, 12, 0, 1.6, 1);
  EXPECT_EQ(orderOf(leaning(brief)), (std::vector<std::size_t>{0, 1, 2}));
  // A patch each: layers stay in their order.
  plan::ToolPlan patches = ledge({2.4, 0.0});
  patches.paths[1].patch = 7;
  EXPECT_EQ(orderOf(patches), (std::vector<std::size_t>{0, 1, 2}));
}

// One path there and back: the unsupported line is printed after the one it may lean on.
TEST(InwardsFirst, PathThatBeginsUnsupportedIsReversed) {
  const auto thereAndBack = [](double there, double back) {
    plan::ToolPlan plan = ledge({there, back});
    plan::ToolPath &first = plan.paths[1], &second = plan.paths[2];
    const auto from = static_cast<std::ptrdiff_t>(second.first);
    std::reverse(plan.position.begin() + from, plan.position.end());
    first.count += second.count;
    plan.paths.pop_back();
    return plan;
  };
  const auto turned = [](const plan::ToolPlan& plan) {
    return toolpath::insideOutOrder(plan, unsupportedOf(plan), process::Tooling(kProcess))
        .at(1)
        .turned;
  };
  EXPECT_TRUE(turned(thereAndBack(1.15, 0.0)));
  EXPECT_FALSE(turned(thereAndBack(0.0, 1.15)));
  EXPECT_FALSE(turned(thereAndBack(2.6, 0.0))) << "too far to lean on";

  plan::ToolPlan plan = thereAndBack(1.15, 0.0);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    plan.speedMmPerS[i] = 5.0F + 0.01F * static_cast<float>(i);
  const plan::ToolPlan after =
      afterPhase(toolpath::PassPhase::BeforeDirections, plan, kNarrowPlate).beads.plan;
  ASSERT_EQ(after.waypointCount(), plan.waypointCount());
  const plan::ToolPath& path = plan.paths[1];
  for (std::size_t k = 0; k < path.count; ++k) {
    const std::size_t was = path.first + path.count - 1 - k;
    EXPECT_EQ(after.position[path.first + k], plan.position[was]);
    if (k > 0) {
      EXPECT_EQ(after.speedMmPerS[path.first + k], plan.speedMmPerS[was + 1]);
    }
  }
}

// Ledges of two to four beads, of any height of layers, tilted: each bead is pressed against the
// one inwards of it, none leans further than it may, middles stay, and directions change gently.
// Where beads are twice as wide as high, some lose contact as the bead below leans.
TEST(Braced, RandomLedgesBecomeSupported) {
  std::size_t before = 0, left = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution<>(from, to)(random);
    };
    const auto height = static_cast<float>(number(0.5, 0.9));
    const double apart = number(1.0, 1.15);
    std::vector<double> offsets;
    for (int k = 0; k <= std::uniform_int_distribution<>(2, 4)(random); ++k)
      offsets.push_back(k * apart);
    plan::ToolPlan plan = ledge(offsets, height);
    const Eigen::AngleAxisd tilt(base::degreesToRadians(number(-20, 20)),
                                 Vector3d(number(-1, 1), number(-1, 1), 0).normalized());
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      plan.position[i] = Vector3d(0, 0, 12) + tilt * plan.position[i];
      plan.direction[i] = tilt * plan.direction[i];
    }
    ASSERT_GT(std::ranges::count(unsupportedOf(plan), 1), 20) << seed;
    const plan::ToolPlan after = bracedPlan(plan);
    for (const plan::ToolPath& path : plan.paths) {
      const auto hangs = [&](const plan::ToolPlan& of) {
        return !toolpath::unsupportedStretches(of, path, unsupportedOf(of), kProcess.bridgeMm)
                    .empty();
      };
      if (path.layer == 0 || !hangs(plan))
        continue;
      ++before;
      if (hangs(after)) {
        ++left;
        EXPECT_LT(height, 0.62f) << seed;
      }
    }
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      EXPECT_LE(leanDeg(plan, after, i), 50.0 + 1e-6);
      const Vector3d middle =
          plan.position[i] - 0.5 * static_cast<double>(plan.heightMm[i]) * plan.direction[i];
      EXPECT_TRUE(middle.isApprox(after.position[i] - 0.5 * static_cast<double>(plan.heightMm[i]) *
                                                          after.direction[i]));
      EXPECT_TRUE(i >= plan.paths[1].first || plan.direction[i] == after.direction[i]);
    }
  }
  EXPECT_GT(before, 200u);
  EXPECT_LT(left, before / 15);
}

// Of a bead that is carried up to x = 0, the unsupported part leans, and the part before it leans
// less and less.
TEST(Braced, TheWayThereIsGentle) {
  plan::ToolPlan plan;
  addPath(plan, -20, 20, 0, 0.8, 0);
  addPath(plan, -20, 0, 1.2, 0.8, 0);
  addPath(plan, -20, 20, 0, 1.6, 1);
  addPath(plan, -20, 20, 1.15, 1.6, 1);
  plan = leaning(std::move(plan));
  const plan::ToolPlan after = bracedPlan(plan);
  const plan::ToolPath& outer = plan.paths.back();
  EXPECT_EQ(leanDeg(plan, after, outer.first), 0.0);
  EXPECT_GT(leanDeg(plan, after, outer.first + outer.count - 1), 9.0);
  for (std::size_t i = outer.first + 1; i < outer.first + outer.count; ++i)
    EXPECT_LE(std::abs(leanDeg(plan, after, i) - leanDeg(plan, after, i - 1)), 15.0 + 1e-6);
}

// Flat layers stay so, though a bead of support among them leans.
TEST(Braced, UprightBeadsStayUpright) {
  plan::ToolPlan plan = ledge({0.0, 1.15, 2.3});
  EXPECT_NE(bracedPlan(plan).direction, plan.direction);
  plan.paths.front().kind = plan::PathKind::Support; // the one that leans
  EXPECT_EQ(bracedPlan(plan).direction, plan.direction);
}

TEST(Braced, BeadWithoutANeighbourStays) {
  for (const double offset : {2.6, 4.0}) {
    const plan::ToolPlan plan = ledge({0.0, offset});
    EXPECT_EQ(bracedPlan(plan).direction, plan.direction);
  }
}

// All passes up to directions: the result is supported everywhere, in an order that allows it.
TEST(Braced, ALedgeOnItsWayToDirections) {
  plan::ToolPlan plan = ledge({3.5, 2.35, 1.2, 0.0});
  for (plan::ToolPath& path : plan.paths)
    path.kind = plan::PathKind::Infill; // walls may be drawn in
  const robot::Cell cell = robot::loadCell("ur5-fixed", kProcess, kNarrowPlate.polygon);
  toolpath::ToolpathOptions options;
  options.platform = kNarrowPlate;
  for (const bool upright : {true, false}) {
    if (upright)
      plan.direction.front() = Vector3d::UnitZ();
    else
      plan = leaning(std::move(plan));
    const toolpath::PassedPlan under = toolpath::runUnsupportedPasses(
        toolpath::PassPhase::BeforeDirections, plan,
        std::vector<Vector3d>(plan.waypointCount(), Vector3d::UnitZ()), nullptr,
        {cell, process::Tooling(kProcess), kNarrowPlate}, {});
    EXPECT_TRUE(under.findings.empty());
    const plan::ToolPlan& ordered = under.beads.plan;
    ASSERT_EQ(ordered.paths.size(), 5u);
    std::vector<double> offsets;
    for (std::size_t p = 1; p < 5; ++p)
      offsets.push_back(ordered.position[ordered.paths[p].first].y());
    EXPECT_EQ(offsets,
              upright ? (std::vector{3.5, 2.35, 1.2, 0.0}) : (std::vector{0.0, 1.2, 2.35, 3.5}));
    const toolpath::OrientResult oriented =
        toolpath::orientDirections(ordered, under.beads.clearDirection, cell,
                                   process::Tooling(kProcess), options, {}, {}, under.grown);
    EXPECT_EQ(oriented.gouges, 0u);
    const auto unsupported = std::ranges::count(unsupportedOf(oriented.plan), 1);
    if (upright) {
      EXPECT_EQ(oriented.plan.direction, ordered.direction); // nothing else may be possible
      EXPECT_GT(unsupported, 20);
      EXPECT_TRUE(oriented.findings.empty());
    } else {
      EXPECT_EQ(unsupported, 0);
      ASSERT_EQ(oriented.findings.size(), 1u); // the three that reach out
      EXPECT_EQ(plan::reportId(oriented.findings.front()), "braced");
      EXPECT_EQ(oriented.findings.front().count, 3u);
      EXPECT_FALSE(oriented.findings.front().blocking);
    }
  }
}
