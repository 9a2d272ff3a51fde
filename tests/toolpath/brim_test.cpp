// The brim: loops around the first layer, outside it, on the plate, before all other paths.
#include "patch_shapes.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "process/process.h"
#include "toolpath/brim.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;

constexpr BrimBead kBead{1.0, 1.2};

Polygon2d square(double sideMm, const Vector2d& at = {0, 0}) {
  const double a = 0.5 * sideMm;
  return {at + Vector2d(-a, -a), at + Vector2d(a, -a), at + Vector2d(a, a), at + Vector2d(-a, a)};
}
Polygon2d reversed(Polygon2d polygon) {
  std::ranges::reverse(polygon);
  return polygon;
}

double toSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm();
}
double toOutline(const Vector2d& p, const Polygon2d& polygon) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    minimum = std::min(minimum, toSegment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return minimum;
}
bool inside(const Vector2d& p, const Polygon2d& polygon) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      in = !in;
  }
  return in;
}
double lengthOf(const BrimLoop& loop) {
  double length = 0.0;
  for (std::size_t i = loop.closed ? 0 : 1; i < loop.points.size(); ++i)
    length += (loop.points[i] - loop.points[i > 0 ? i - 1 : loop.points.size() - 1]).norm();
  return length;
}

TEST(Brim, loopsOfASquareHaveTheLengthOfItsOffsets) {
  const Brim brim = brimAround({square(20)}, square(200), 4.0, kBead);
  ASSERT_EQ(brim.loops.size(), 4u);
  EXPECT_FALSE(brim.cutAt);
  for (std::size_t k = 0; k < 4; ++k) {
    const double distance = 3.5 - static_cast<double>(k); // From the outermost inwards
    EXPECT_TRUE(brim.loops[k].closed);
    EXPECT_NEAR(lengthOf(brim.loops[k]), 80.0 + 2.0 * std::numbers::pi * distance, 0.15);
    for (const Vector2d& p : brim.loops[k].points)
      EXPECT_NEAR(toOutline(p, square(20)), distance, 0.03);
  }
}

TEST(Brim, hasAtLeastOneLoop) {
  EXPECT_EQ(brimAround({square(20)}, square(200), 0.2, kBead).loops.size(), 1u);
  EXPECT_TRUE(brimAround({}, square(200), 4.0, kBead).loops.empty());
}

TEST(Brim, holesGetNone) {
  const Brim brim = brimAround({square(40), reversed(square(30))}, square(200), 4.0, kBead);
  EXPECT_EQ(brim.loops.size(), 4u);
  for (const BrimLoop& loop : brim.loops)
    for (const Vector2d& p : loop.points)
      EXPECT_FALSE(inside(p, square(40)));
}

// A pin of 6 mm in a hole of 16 mm: 5 mm between them, and 1.5 mm to the wall stay free.
TEST(Brim, anIslandInAHoleHasLoopsApartFromTheWall) {
  const Brim brim =
      brimAround({square(40), reversed(square(16)), square(6)}, square(200), 6.0, kBead);
  std::size_t within = 0;
  for (const BrimLoop& loop : brim.loops) {
    if (!inside(loop.points.front(), square(40)))
      continue;
    ++within;
    for (const Vector2d& p : loop.points) {
      EXPECT_GE(toOutline(p, square(16)), 1.5 - 0.03);
      EXPECT_GE(toOutline(p, square(6)), 0.5 - 0.03);
      EXPECT_TRUE(inside(p, square(16)));
    }
  }
  EXPECT_GE(within, 3u);
}

TEST(Brim, supportsHaveLoopsOnlyOutside) {
  const Polygon2d outer = square(40), hole = reversed(square(16));
  const auto loops = [&](const std::vector<Polygon2d>& part,
                         const std::vector<Polygon2d>& supports) {
    return brimAround(part, square(200), 3.0, kBead, supports).loops.size();
  };
  EXPECT_EQ(loops({outer, hole}, {square(6)}), 3u);
  EXPECT_EQ(loops({outer, hole, square(6)}, {}), 6u);
  EXPECT_EQ(loops({square(10)}, {square(10, {40, 0})}), 6u);
}

TEST(Brim, loopsOfNearIslandsAreJoined) {
  const std::vector<Polygon2d> islands{square(10, {-8, 0}), square(10, {8, 0})}; // 6 mm apart
  const Brim brim = brimAround(islands, square(200), 4.0, kBead);
  // At 3.5 mm one loop around both, nearer ones around each.
  EXPECT_EQ(brim.loops.size(), 1u + 3u * 2u);
  EXPECT_EQ(
      brimAround({square(10, {-20, 0}), square(10, {20, 0})}, square(200), 4.0, kBead).loops.size(),
      8u);
}

// Four bars around a square of 20 mm, 2 mm apart at its corners.
TEST(Brim, pocketsBetweenIslandsGetNone) {
  const auto bar = [](const Vector2d& at, double dx, double dy) {
    return Polygon2d{at + Vector2d(-dx, -dy), at + Vector2d(dx, -dy), at + Vector2d(dx, dy),
                     at + Vector2d(-dx, dy)};
  };
  const Brim brim = brimAround(
      {bar({-13, 0}, 3, 10), bar({13, 0}, 3, 10), bar({0, -15}, 10, 3), bar({0, 15}, 10, 3)},
      square(200), 3.0, kBead);
  EXPECT_FALSE(brim.loops.empty());
  bool around = false; // All four
  for (const BrimLoop& loop : brim.loops) {
    double minimum = 1e9, maximum = 0.0;
    for (const Vector2d& p : loop.points) {
      minimum = std::min(minimum, p.norm());
      maximum = std::max(maximum, p.cwiseAbs().maxCoeff());
    }
    around = around || minimum > 14.0;
    EXPECT_GT(maximum, 10.0); // Not in the pocket
  }
  EXPECT_TRUE(around);
}

TEST(Brim, islandsWithoutABeadGetNone) {
  EXPECT_EQ(brimAround({square(20), square(0.5, {40, 0})}, square(200), 1.0, kBead).loops.size(),
            1u);
}

TEST(Brim, overlappingPolygonsCountOnce) {
  const Brim brim = brimAround({square(10, {-3, 0}), square(10, {3, 0})}, square(200), 1.0, kBead);
  ASSERT_EQ(brim.loops.size(), 1u);
  EXPECT_NEAR(lengthOf(brim.loops[0]), 52.0 + std::numbers::pi, 0.1);
}

TEST(Brim, isCutAtThePlatesEdge) {
  // 3 mm are left at each side: loops at 0.5, 1.5 and (with half a bead of 0.6) no more.
  const Brim brim = brimAround({square(20)}, square(26), 4.0, kBead);
  ASSERT_TRUE(brim.cutAt);
  EXPECT_GT(brim.cutMm, 50.0);
  for (const BrimLoop& loop : brim.loops)
    for (const Vector2d& p : loop.points)
      EXPECT_LE(p.cwiseAbs().maxCoeff(), 13.0 - 0.6 + 1e-3);
  // At one side only: the loop that is cut there stays in one piece.
  const Brim beside = brimAround({square(20, {-10, 0})}, square(42), 1.0, kBead);
  ASSERT_EQ(beside.loops.size(), 1u);
  EXPECT_FALSE(beside.loops.front().closed);
  EXPECT_TRUE(beside.cutAt);
}

// Property test: outside every island, at least half a hatch away, on the plate, loops a hatch
// apart.
TEST(Brim, ofRandomIslandsNeverTouchesThem) {
  std::mt19937 random(7);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const Polygon2d plate = square(120);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    std::vector<Polygon2d> islands;
    for (int i = 0, n = 1 + static_cast<int>(between(0, 5)); i < n; ++i) {
      const Vector2d at(between(-55, 55), between(-55, 55));
      Polygon2d star;
      const int corners = 3 + static_cast<int>(between(0, 9));
      for (int c = 0; c < corners; ++c) {
        const double angle = 2.0 * std::numbers::pi * c / corners, r = between(2, 15);
        star.push_back(at + r * Vector2d(std::cos(angle), std::sin(angle)));
      }
      islands.push_back(star);
    }
    const Brim brim = brimAround(islands, plate, between(0.5, 8.0), kBead);
    double length = 0.0;
    for (const BrimLoop& loop : brim.loops) {
      length += lengthOf(loop);
      for (const Vector2d& p : loop.points) {
        ASSERT_LE(p.cwiseAbs().maxCoeff(), 60.0 - 0.6 + 1e-3);
        for (const Polygon2d& island : islands) {
          ASSERT_FALSE(inside(p, island));
          ASSERT_GE(toOutline(p, island), 0.5 - 0.03);
        }
      }
    }
    EXPECT_NEAR(length, brim.lengthMm, 1e-3 * (1.0 + length));
    EXPECT_EQ(brim.cutAt.has_value(), brim.cutMm > 0.0);
  }
}

// One layer of a disc on a plate: layer height 0.8 mm, as in the process.
layers::LayerStack discStack(double radiusMm) {
  layers::LayerStack stack;
  stack.patches.push_back(test::patchOver({test::circle(radiusMm)}));
  stack.layerCount = 1;
  return stack;
}

TEST(Brim, comesBeforeAllOtherPathsAndIsWaste) {
  const process::Process process;
  const layers::LayerStack stack = discStack(10.0);
  plan::ToolPlan plan;
  for (const double x : {-5.0, 5.0})
    plan.position.emplace_back(x, 0.0, process.layerHeightMm);
  plan.direction.assign(2, Eigen::Vector3d::UnitZ());
  plan.widthMm.assign(2, 1.2f);
  plan.heightMm.assign(2, 0.8f);
  plan.speedMmPerS.assign(2, 20.0f);
  plan.paths.push_back({.first = 0, .count = 2});
  ToolpathOptions options;
  options.platform = square(100);
  const plan::ToolPlan before = plan;
  EXPECT_FALSE(addBrim(plan, stack, process::Tooling(process), options));
  EXPECT_EQ(plan.paths.size(), before.paths.size());
  options.brimWidthMm = 5.0;
  EXPECT_FALSE(addBrim(plan, stack, process::Tooling(process), options));
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const auto loops = static_cast<std::size_t>(std::lround(5.0 / hatch));
  ASSERT_EQ(plan.paths.size(), 1u + loops);
  EXPECT_TRUE(plan.primes());
  EXPECT_FALSE(plan.isPrimeInAir());
  for (std::size_t k = 0; k < loops; ++k) {
    const plan::ToolPath& path = plan.paths[k];
    EXPECT_EQ(path.kind, plan::PathKind::Skirt);
    EXPECT_TRUE(path.closed);
    const double radius = 10.0 + (static_cast<double>(loops - k) - 0.5) * hatch;
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      EXPECT_NEAR(plan.position[i].head<2>().norm(), radius, 0.06);
      EXPECT_NEAR(plan.position[i].z(), plan.heightMm[i], 1e-6);
      EXPECT_EQ(plan.heightMm[i], static_cast<float>(process.layerHeightMm));
      if (i > path.first) {
        EXPECT_LE((plan.position[i] - plan.position[i - 1]).norm(), options.stepMm + 1e-9);
      }
    }
    EXPECT_EQ(plan.position[path.first], plan.position[path.first + path.count - 1]);
  }
  EXPECT_EQ(plan.paths.back().first + 2, plan.waypointCount());
  EXPECT_EQ(plan.position.back(), before.position.back());

  plan = before;
  plan.paths[0].tool = 1;
  addBrim(plan, stack, process::Tooling({{process}, {process}}), options);
  for (const plan::ToolPath& path : plan.paths)
    EXPECT_EQ(path.tool, 1) << "of the tool that prints first";

  options.platform = square(24);
  plan = before;
  const auto cut = addBrim(plan, stack, process::Tooling(process), options);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->kind, plan::FindingKind::BrimCut);
  EXPECT_FALSE(cut->blocking);
}

} // namespace
} // namespace voluta::toolpath
