// Bridges of plane layers where their spans are known, and judged by a raster of its own.
#include "base/run_context.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_volume.h"
#include "toolpath/plane/level_patches.h"
#include "toolpath/sparse/cover_layers.h"
#include "toolpath/unsupported/bridge_beads.h"
#include "toolpath/unsupported/bridge_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace voluta::toolpath {
namespace {

using ClipperLib::Paths;
using Eigen::Vector2d;
using Eigen::Vector3d;
using plan::PathKind;

constexpr double kHeight = 0.2;

process::Process fineProcess() {
  process::Process process;
  process.layerHeightMm = kHeight;
  process.layerHeightMinMm = 0.08;
  process.layerHeightMaxMm = 0.32;
  process.beadWidthMm = 0.45;
  process.beadWidthMinMm = 0.4;
  process.beadWidthMaxMm = 0.8;
  process.bridgeMm = 4.0;
  return process;
}
double hatchMm() {
  return process::hatchOf(0.45, kHeight);
}

// A rectangle between two corners, turned about the origin.
struct Box {
  double x0, y0, x1, y1, degrees = 0.0;

  test::Loop loop() const {
    const Eigen::Rotation2Dd rotation(base::degreesToRadians(degrees));
    test::Loop loop;
    for (const Vector2d& p :
         {Vector2d(x0, y0), Vector2d(x1, y0), Vector2d(x1, y1), Vector2d(x0, y1)})
      loop.push_back(rotation * p);
    return loop;
  }
  bool contains(const Vector2d& place) const {
    const Vector2d p = Eigen::Rotation2Dd(-base::degreesToRadians(degrees)) * place;
    return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1;
  }
};

ClipperLib::Path pathOf(const test::Loop& loop) {
  ClipperLib::Path path;
  for (const Vector2d& p : loop)
    path.push_back(geometry::pathPoint(p));
  return path;
}

// Boxes, and boxes that are cut out of them.
struct Shape {
  std::vector<Box> boxes, holes = {};

  Paths paths() const {
    Paths all, cut;
    for (const Box& box : boxes)
      all.push_back(pathOf(box.loop()));
    for (const Box& box : holes)
      cut.push_back(pathOf(box.loop()));
    return geometry::combined(all, cut, ClipperLib::ctDifference);
  }
  bool contains(const Vector2d& place) const {
    const auto has = [&](const Box& box) { return box.contains(place); };
    return std::ranges::any_of(boxes, has) && std::ranges::none_of(holes, has);
  }
};

double offDeg(double radians, double degrees) {
  return std::abs(std::remainder(base::radiansToDegrees(radians) - degrees, 180.0));
}

std::vector<BridgeRegion> regionsOver(const Shape& inside, const Shape& below) {
  return bridgeRegions(inside.paths(), below.paths(), fineProcess());
}

PlanePatch planeAt(double z) {
  PlanePatch plane;
  plane.heightMm = z;
  plane.thicknessMm = kHeight;
  return plane;
}

std::vector<Bead> beadsOver(const BridgeRegion& region, const Shape& below, double longestMm) {
  return bridgeBeads(region, below.paths(), planeAt(1.0), fineProcess(), longestMm, 1.0);
}

// What a bead does between its places on the layer below, sampled along its middle.
struct AirRaster {
  double onHoldMm = 0.0, bridgedMm = 0.0, looseMm = 0.0, longestMm = 0.0;
  int turns = 0; // in the air

  void add(const Bead& bead, const Shape& below) {
    constexpr double kStepMm = 0.02, kTurnMm = 0.05;
    std::vector<Vector2d> places;
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
      const Vector2d from = bead.points[i].middle.head<2>(),
                     along = bead.points[i + 1].middle.head<2>() - from;
      const int steps = std::max(1, static_cast<int>(along.norm() / kStepMm));
      for (int k = 0; k < steps; ++k)
        places.emplace_back(from + along * (k + 0.5) / steps);
    }
    for (std::size_t begin = 0; begin < places.size();) {
      const bool isOn = below.contains(places[begin]);
      std::size_t end = begin;
      double length = 0.0;
      while (end < places.size() && below.contains(places[end]) == isOn) {
        length += end > begin ? (places[end] - places[end - 1]).norm() : kStepMm;
        ++end;
      }
      if (isOn)
        onHoldMm += length;
      else if (begin == 0 || end == places.size())
        looseMm += length;
      else {
        bridgedMm += length;
        longestMm = std::max(longestMm, length);
        const double chord = (places[end - 1] - places[begin]).norm();
        turns += length > chord + kTurnMm ? 1 : 0;
      }
      begin = end;
    }
  }
};

AirRaster rasterOf(const std::vector<Bead>& beads, const Shape& below) {
  AirRaster raster;
  for (const Bead& bead : beads)
    raster.add(bead, below);
  return raster;
}

// A deck over two piers, turned.
TEST(BridgeRegions, SpanTheGapBetweenPiersStraight) {
  for (const double gap : {2.0, 6.0, 15.0})
    for (const double degrees : {0.0, 20.0, 30.0, 37.0, 90.0, 135.0, 171.0}) {
      SCOPED_TRACE(testing::Message() << gap << " mm, " << degrees);
      const Shape deck{{{-20, -8, 20, 8, degrees}}};
      const Shape piers{{{-20, -8, -0.5 * gap, 8, degrees}, {0.5 * gap, -8, 20, 8, degrees}}};
      const auto regions = regionsOver(deck, piers);
      ASSERT_EQ(regions.size(), 1u);
      EXPECT_LE(offDeg(regions[0].directionRad, degrees), 0.1);
      EXPECT_NEAR(regions[0].longestMm, gap, 0.01);
      EXPECT_NEAR(geometry::areaMm2(regions[0].area), 16.0 * (gap + 4.0 * hatchMm()), 0.6);
      const auto beads = beadsOver(regions[0], piers, 20.0);
      ASSERT_EQ(beads.size(), 1u) << "joined on the piers";
      EXPECT_EQ(beads[0].kind, PathKind::Bridge);
      const AirRaster raster = rasterOf(beads, piers);
      EXPECT_NEAR(raster.bridgedMm, gap * std::round(16.0 / hatchMm()), 0.02 * raster.bridgedMm);
      EXPECT_NEAR(raster.longestMm, gap, 0.05);
      EXPECT_EQ(raster.turns, 0);
      EXPECT_EQ(raster.looseMm, 0.0);
      EXPECT_NEAR(volumeOf(beads), kHeight * geometry::areaMm2(regions[0].area),
                  0.01 * volumeOf(beads));
    }
}

TEST(BridgeRegions, LongerThanTheMaterialBridgesAreNone) {
  const Shape deck{{{-20, -8, 20, 8}}}, piers{{{-20, -8, -5, 8}, {5, -8, 20, 8}}};
  const auto regions = regionsOver(deck, piers);
  ASSERT_EQ(regions.size(), 1u);
  for (const double longest : {9.9, 10.1})
    for (const Bead& bead : beadsOver(regions[0], piers, longest))
      EXPECT_EQ(bead.kind, longest > 10.0 ? PathKind::Bridge : PathKind::Infill) << longest;
}

TEST(BridgeRegions, CrossAWindowTheShortWay) {
  const Shape floor{{{-15, -15, 15, 15}}};
  for (const double degrees : {0.0, 25.0, 90.0}) {
    Shape below = floor;
    below.holes.push_back({-10, -3, 10, 3, degrees});
    const auto regions = regionsOver(floor, below);
    ASSERT_EQ(regions.size(), 1u) << degrees;
    EXPECT_LE(offDeg(regions[0].directionRad, degrees + 90.0), 0.1) << degrees;
    EXPECT_NEAR(regions[0].longestMm, 6.0, 0.01) << degrees;
  }
}

TEST(BridgeRegions, HaveDirectionsOfTheirOwn) {
  const Shape floor{{{0, 0, 50, 30}}};
  Shape below = floor;
  below.holes = {{4, 12, 24, 18}, {34, 4, 40, 26}};
  const auto regions = regionsOver(floor, below);
  ASSERT_EQ(regions.size(), 2u);
  for (const BridgeRegion& region : regions) {
    const bool isFirst = geometry::pointMm(region.area.front().front()).x() < 29.0;
    EXPECT_LE(offDeg(region.directionRad, isFirst ? 90.0 : 0.0), 0.1);
    EXPECT_NEAR(region.longestMm, 6.0, 0.01);
    const AirRaster raster = rasterOf(beadsOver(region, below, 20.0), below);
    EXPECT_EQ(raster.turns, 0);
    EXPECT_EQ(raster.looseMm, 0.0);
  }
  EXPECT_TRUE(
      geometry::combined(regions[0].area, regions[1].area, ClipperLib::ctIntersection).empty());
}

// Both arms of an L, 6 mm wide: the diagonal through its inner corner is the shortest line that
// crosses both.
TEST(BridgeRegions, CrossAnAngleDiagonally) {
  const Shape floor{{{0, 0, 30, 30}}};
  Shape below = floor;
  below.holes = {{6, 6, 12, 24}, {6, 6, 24, 12}};
  const auto regions = regionsOver(floor, below);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_LE(regions[0].longestMm, 6.0 * std::sqrt(2.0) + 0.05);
  const AirRaster raster = rasterOf(beadsOver(regions[0], below, 20.0), below);
  EXPECT_EQ(raster.turns, 0);
  EXPECT_EQ(raster.looseMm, 0.0);
  EXPECT_LE(raster.longestMm, 6.0 * std::sqrt(2.0) + 0.05);
}

TEST(BridgeRegions, NeedTwoHolds) {
  const Shape shelf{{{0, 0, 20, 12}}};
  EXPECT_TRUE(regionsOver(shelf, {{{0, 0, 6, 12}}}).empty()) << "a cantilever";
  EXPECT_TRUE(regionsOver({{{-10, -10, 10, 10}}}, {{{-2, -2, 2, 2}}}).empty()) << "a table";
  EXPECT_TRUE(regionsOver(shelf, {{{0, 0, 20, 12}}}).empty()) << "no gap";
  EXPECT_TRUE(regionsOver(shelf, {{{0, 0, 9.7, 12}, {10.3, 0, 20, 12}}}).empty())
      << "a gap narrower than one and a half beads";
}

// Between two piers that are narrower than the deck, only the strip between them is a bridge.
TEST(BridgeRegions, LeaveOverhangsBesideThem) {
  const Shape deck{{{-15, -10, 15, 10}}}, piers{{{-12, -4, -5, 4}, {5, -4, 12, 4}}};
  const auto regions = regionsOver(deck, piers);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_LE(offDeg(regions[0].directionRad, 0.0), 0.1);
  for (const ClipperLib::Path& path : regions[0].area)
    for (const ClipperLib::IntPoint& p : path)
      EXPECT_LE(std::abs(geometry::pointMm(p).y()), 4.0 + hatchMm());
  const AirRaster raster = rasterOf(beadsOver(regions[0], piers, 20.0), piers);
  EXPECT_EQ(raster.turns, 0);
  EXPECT_NEAR(raster.longestMm, 10.0, 0.05);
  EXPECT_LE(raster.looseMm, 0.1 * raster.bridgedMm);
}

// Random windows in a floor and random decks over piers: all that the raster finds in the air is
// held at both ends and does not turn.
TEST(BridgeRegions, HoldRandomSpans) {
  std::mt19937_64 random(17);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int found = 0, expected = 0;
  for (int n = 0; n < test::ofSeeds(200, 2000); ++n) {
    SCOPED_TRACE(n);
    const double degrees = within(0.0, 180.0), shorter = within(1.0, 14.0),
                 longer = shorter * within(1.1, 3.0);
    const Box gap{-0.5 * shorter, -0.5 * longer, 0.5 * shorter, 0.5 * longer, degrees};
    Shape inside, below;
    if (n % 2 == 0) {
      inside.boxes = {{-40, -40, 40, 40}};
      below = inside;
      below.holes = {gap};
    } else {
      const double pier = within(2.0, 10.0);
      inside.boxes = {{gap.x0 - pier, gap.y0, gap.x1 + pier, gap.y1, degrees}};
      below.boxes = {{gap.x0 - pier, gap.y0, gap.x0, gap.y1, degrees},
                     {gap.x1, gap.y0, gap.x1 + pier, gap.y1, degrees}};
    }
    ++expected;
    const auto regions = regionsOver(inside, below);
    ASSERT_EQ(regions.size(), 1u);
    ++found;
    EXPECT_NEAR(regions[0].longestMm, shorter, 0.02);
    EXPECT_LE(offDeg(regions[0].directionRad, degrees), 0.1);
    const auto beads = beadsOver(regions[0], below, shorter + 0.1);
    for (const Bead& bead : beads)
      EXPECT_EQ(bead.kind, PathKind::Bridge);
    const AirRaster raster = rasterOf(beads, below);
    EXPECT_EQ(raster.turns, 0);
    EXPECT_EQ(raster.looseMm, 0.0);
    EXPECT_LE(raster.longestMm, shorter + 0.05);
    EXPECT_NEAR(raster.bridgedMm * hatchMm(), shorter * longer, hatchMm() * shorter + 0.1);
  }
  EXPECT_EQ(found, expected);
}

// Two towers beside each other: each layer rests on that of its own, and the lowest on none.
TEST(LevelPatches, FindTheLayerBelow) {
  layers::LayerStack stack;
  for (int layer = 0; layer < 3; ++layer)
    for (const double x : {0.0, 30.0}) {
      PlanePatch plane = planeAt((layer + 0.5) * kHeight);
      plane.outline = Shape{{{x, 0, x + 10.0 - layer, 10}}}.paths();
      stack.patches.push_back(patchOver(plane.outline, plane, {}).value());
    }
  const LevelPatches levels(stack, base::RunContext());
  for (std::size_t i = 0; i < 6; ++i) {
    ASSERT_NE(levels.patch(i), nullptr);
    const Paths below = levels.below(*levels.patch(i));
    const double expected = i < 2 ? 0.0 : i < 4 ? 100.0 : 90.0;
    EXPECT_NEAR(geometry::areaMm2(below), expected, 1e-3) << i;
  }
}

// Layers of a stack: a floor, by default with two windows, and a lid over it.
struct Lid {
  Shape floor, lid;
  layers::LayerStack stack;
  process::Process process = fineProcess();
  ToolpathOptions options;

  Lid()
      : Lid(Shape{{{0, 0, 50, 30}}, {{4, 12, 24, 18}, {34, 4, 40, 26}}}, Shape{{{0, 0, 50, 30}}}) {}
  Lid(Shape below, Shape above) : floor(std::move(below)), lid(std::move(above)) {
    const auto add = [&](const Shape& shape, int layer) {
      PlanePatch plane = planeAt((layer + 0.5) * kHeight);
      plane.outline = shape.paths();
      layers::Patch like;
      like.layer = layer;
      stack.patches.push_back(patchOver(plane.outline, plane, like).value());
      stack.layerCount = layer + 1;
    };
    add(floor, 0);
    for (int layer = 1; layer < 3; ++layer)
      add(lid, layer);
    process.stepMm = 1.0;
  }
  std::vector<PatchCover> covers() const {
    const CoverRules rules{options, process::Tooling(process)};
    return coverLayers(stack, {&rules, 1}, 1.0, base::RunContext()).covers;
  }
};

TEST(BridgedLayers, KeepTheirOwnPatternBesideTheBridges) {
  Lid scene;
  scene.options.bridgesMaySag = true;
  const auto covers = scene.covers();
  ASSERT_EQ(covers.size(), 3u);
  double usualMm = 0.0, otherMm = 0.0;
  std::vector<Bead> bridges, others;
  for (const Bead& bead : covers[1].beads) {
    if (bead.kind == PathKind::Bridge)
      bridges.push_back(bead);
    else if (bead.kind != PathKind::Wall)
      others.push_back(bead);
    if (bead.kind != PathKind::Infill)
      continue;
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
      const Vector3d along = bead.points[i + 1].middle - bead.points[i].middle;
      const double off = offDeg(std::atan2(along.y(), along.x()), 45.0); // 135 + 90
      (off < 3.0 ? usualMm : otherMm) += along.norm();
    }
  }
  EXPECT_GE(usualMm, 0.85 * (usualMm + otherMm));
  ASSERT_GE(bridges.size(), 2u);
  const AirRaster raster = rasterOf(bridges, scene.floor);
  EXPECT_EQ(raster.turns, 0);
  EXPECT_EQ(raster.looseMm, 0.0);
  EXPECT_NEAR(raster.longestMm, 6.0, 0.05);
  EXPECT_NEAR(raster.bridgedMm * hatchMm(), 20.0 * 6.0 + 22.0 * 6.0, 8.0);
  const AirRaster rest = rasterOf(others, scene.floor);
  EXPECT_LE(rest.bridgedMm + rest.looseMm, 0.5) << "all of the windows is bridged";
  for (const std::size_t i : {0u, 2u})
    for (const Bead& bead : covers[i].beads)
      EXPECT_NE(bead.kind, PathKind::Bridge) << i;
}

// A lid lies on walls as thin as one bead: its lines reach them in spite of its own walls.
TEST(BridgedLayers, ReachThinWalls) {
  for (const double beads : {1.0, 1.5, 2.0, 3.0, 6.0}) {
    SCOPED_TRACE(beads);
    const double t = beads * 0.45;
    Lid scene(Shape{{{0, 0, 20, 12}}, {{t, t, 20 - t, 12 - t}}}, Shape{{{0, 0, 20, 12}}});
    scene.process.bridgeMm = 15.0;
    const auto covers = scene.covers();
    std::vector<Bead> bridges;
    int walls = 0;
    for (const Bead& bead : covers[1].beads) {
      if (bead.kind == PathKind::Bridge)
        bridges.push_back(bead);
      walls = std::max(walls, bead.kind == PathKind::Wall ? bead.ring + 1 : 0);
    }
    EXPECT_EQ(walls, beads < 2.0 ? 0 : beads < 3.0 ? 1 : 2);
    const AirRaster raster = rasterOf(bridges, scene.floor);
    EXPECT_EQ(raster.turns, 0);
    EXPECT_EQ(raster.looseMm, 0.0);
    EXPECT_NEAR(raster.longestMm, 12.0 - 2.0 * t, 0.05);
    EXPECT_NEAR(raster.bridgedMm * hatchMm(), (20.0 - 2.0 * t) * (12.0 - 2.0 * t),
                0.1 * (20.0 - 2.0 * t) * (12.0 - 2.0 * t));
    EXPECT_NEAR(volumeOf(covers[1].beads), 20.0 * 12.0 * kHeight, 0.03 * 20.0 * 12.0 * kHeight);
    for (const Bead& bead : covers[2].beads)
      EXPECT_NE(bead.kind, PathKind::Bridge);
  }
}

// The beads of a layer with bridges fill it as those of one without.
TEST(BridgedLayers, AreFilled) {
  for (const char* infill : {"zigzag", "concentric"}) {
    SCOPED_TRACE(infill);
    Lid scene;
    scene.options.infill = infill;
    const auto covers = scene.covers();
    EXPECT_NEAR(covers[1].areaMm2, 50.0 * 30.0, 0.5);
    EXPECT_NEAR(covers[1].volumeMm3, 50.0 * 30.0 * kHeight, 0.1);
    EXPECT_NEAR(volumeOf(covers[1].beads), covers[1].volumeMm3, 0.01 * covers[1].volumeMm3);
    EXPECT_NEAR(covers[1].beadVolumeMm3, volumeOf(covers[1].beads), 1e-6);
    EXPECT_GE(covers[1].coveredMm2, 0.98 * covers[1].areaMm2);
  }
}

// Without walls, the outline is the edge of the bridge.
TEST(BridgedLayers, NeedNoWalls) {
  Lid scene;
  scene.options.walls = 0;
  const auto covers = scene.covers();
  EXPECT_NEAR(volumeOf(covers[1].beads), 50.0 * 30.0 * kHeight, 0.02 * 50.0 * 30.0 * kHeight);
  EXPECT_TRUE(std::ranges::any_of(covers[1].beads,
                                  [](const Bead& b) { return b.kind == PathKind::Infill; }));
}

} // namespace
} // namespace voluta::toolpath
