// The solids into which regions divide a part, and the layers of a skin, in closed form.
#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "regions/part_regions.h"

#include "helpers/layer_volume.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::regions {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;
using test::operator+;
using test::operator-;

const substrate::LevelOptions kLevels{0.8, 0.4, 1.0, 0.0, 1.2};

// A cap of a sphere on a cylinder: the steepest slope is at its edge.
TriangleMesh dome(double radius, double edgeRadius, double baseMm) {
  const double middle = baseMm - std::sqrt(radius * radius - edgeRadius * edgeRadius);
  std::vector<Eigen::Vector2d> section{{0.01, 0.0}, {edgeRadius, 0.0}};
  for (int i = 0; i <= 60; ++i) {
    const double r = std::max(0.01, edgeRadius * (1.0 - i / 60.0));
    section.emplace_back(r, middle + std::sqrt(radius * radius - r * r));
  }
  return test::turned(section, 120);
}

TEST(PartRegions, CutsLeaveTheRemainder) {
  const TriangleMesh part = test::box({-20, -15, 0}, {20, 15, 10});
  const std::vector<project::Region> all{{.shape = "cylinder:5,0,5,10,20", .use = "cut"},
                                         {.shape = "height:2,4", .use = "settings"},
                                         {.shape = "box:-20,0,5,4,4,4", .use = "cut"}};
  const TriangleMesh left = withoutCuts({part}, all, kLevels, {});
  EXPECT_NEAR(geometry::volume(left), 12000.0 - base::kPi * 250.0 - 32.0, 0.5);
  const std::vector<project::Region> whole{{.shape = "sphere:0,0,0,200", .use = "cut"}};
  EXPECT_THROW(withoutCuts({part}, whole, kLevels, {}), base::Error);
}

// Below a flat top the skin is a slab; at constant depth it follows a dome.
TEST(PartRegions, ASkinAndItsCoreAreThePart) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(12.0, 30.0), depth(0.8, 3.2);
  for (int i = 0; i < 12; ++i) {
    const double a = size(random), b = size(random), h = size(random), d = depth(random);
    const TriangleMesh box = test::box({0, 0, 0}, {a, b, h});
    const std::vector<project::Region> skin{
        {.shape = "skin:" + std::to_string(d), .use = "surface"}};
    const PartRegions made = divided({box}, skin, kLevels, {});
    ASSERT_EQ(made.layered.size(), 1u);
    EXPECT_NEAR(geometry::volume(made.layered[0].solid) / (a * b * d), 1.0, 0.01);
    EXPECT_NEAR(geometry::volume(made.rest) + geometry::volume(made.layered[0].solid), a * b * h,
                1e-3);
    const substrate::StackedLevels layers =
        layersOf(skin[0], made.layered[0], {box, made.rest}, kLevels, {});
    EXPECT_EQ(layers.stack.layerCount,
              std::clamp(static_cast<int>(std::lround(d / 0.8)), static_cast<int>(std::ceil(d)),
                         static_cast<int>(std::floor(d / 0.4))));
    EXPECT_NEAR(test::volumeOf(layers.stack) / (a * b * d), 1.0, 0.01);
  }
}

TEST(PartRegions, LayersOfASkinAreParallelToADome) {
  const double radius = 40.0, edge = 25.0, base = 6.0, depth = 2.4;
  const TriangleMesh part = dome(radius, edge, base);
  const std::vector<project::Region> skin{{.shape = "skin:2.4", .use = "surface"}};
  const PartRegions made = divided({part}, skin, kLevels, {});
  ASSERT_EQ(made.layered.size(), 1u);
  const substrate::StackedLevels layers =
      layersOf(skin[0], made.layered[0], {part, made.rest}, kLevels, {});
  ASSERT_EQ(layers.stack.layerCount, 3);
  const Vector3d middle(0.0, 0.0, base - std::sqrt(radius * radius - edge * edge));
  std::size_t vertices = 0, askew = 0;
  for (const layers::Patch& patch : layers.stack.patches)
    for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v) {
      const Vector3d out = patch.surface.vertices[v] - middle;
      EXPECT_NEAR(out.norm(), radius - depth + 0.8 * (patch.layer + 0.5), 0.05);
      ++vertices;
      askew += out.normalized().dot(patch.direction[v]) < 0.99 ? 1 : 0;
      EXPECT_NEAR(patch.thicknessMm[v], 0.8, 0.03);
    }
  EXPECT_LT(askew, vertices / 1000); // at the edge of the dome
  EXPECT_NEAR(test::volumeOf(layers.stack) / geometry::volume(made.layered[0].solid), 1.0, 0.01);
}

// The higher half of a step keeps its wall: the skin of the lower one ends there.
TEST(PartRegions, ASkinEndsAtARisingWall) {
  const TriangleMesh part = test::box({0, 0, 0}, {40, 20, 8}) + test::box({20, 0, 4}, {40, 20, 20});
  const std::vector<project::Region> skin{{.shape = "skin:1.6", .use = "surface"}};
  const PartRegions made = divided({part}, skin, kLevels, {});
  double mm3 = 0.0;
  for (const LayeredRegion& region : made.layered)
    mm3 += geometry::volume(region.solid);
  EXPECT_NEAR(mm3 / (2.0 * 20.0 * 20.0 * 1.6), 1.0, 0.02);
}

// Layers of a jacket are at constant distance from the core.
TEST(PartRegions, AJacketIsWoundAroundItsCore) {
  const TriangleMesh part = test::cylinder({0, 0, 0}, {0, 0, 30}, 12.0);
  const std::vector<project::Region> jacket{{.shape = "height:5,25", .use = "around"}};
  // The core stands through the range of heights.
  const TriangleMesh core = test::cylinder({0, 0, 0}, {0, 0, 30}, 9.6);
  const TriangleMesh solid =
      test::cylinder({0, 0, 5}, {0, 0, 25}, 12.0) - test::cylinder({0, 0, -1}, {0, 0, 31}, 9.6);
  const substrate::StackedLevels layers =
      layersOf(jacket[0], {0, solid}, {part, core}, kLevels, {});
  EXPECT_EQ(layers.stack.layerCount, 3);
  for (const layers::Patch& patch : layers.stack.patches)
    for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v) {
      const Eigen::Vector2d at = patch.surface.vertices[v].head<2>();
      EXPECT_NEAR(at.norm(), 9.6 + 0.8 * (patch.layer + 0.5), 0.12);
      EXPECT_NEAR(patch.direction[v].z(), 0.0, 0.01);
    }
  EXPECT_NEAR(test::volumeOf(layers.stack) / geometry::volume(solid), 1.0, 0.02);
}

// The faces of a dome on one side of a plane are painted: their skin ends there.
TEST(PartRegions, ASkinFollowsPaintedFaces) {
  const double radius = 25.0, edge = 15.0, base = 6.0, depth = 2.4;
  const TriangleMesh part = dome(radius, edge, base);
  for (const bool isWhole : {true, false}) {
    std::vector<bool> isPainted(part.triangles.size());
    for (std::size_t t = 0; t < isPainted.size(); ++t) {
      const Vector3d middle = (part.corner(t, 0) + part.corner(t, 1) + part.corner(t, 2)) / 3.0;
      isPainted[t] = geometry::triangleNormal(part, t).z() > 0.5 && (isWhole || middle.x() > 0.0);
    }
    auto painted = std::make_shared<TriangleMesh>(geometry::subMesh(part, isPainted));
    const std::vector<project::Region> skin{
        {.shape = "painted:2.4", .use = "surface", .mesh = painted}};
    const PartRegions made = divided({part}, skin, kLevels, {});
    ASSERT_EQ(made.layered.size(), 1u);
    // A shell of a ball below the dome, and the wedge at the ridge between its end and the side.
    const double slope = std::asin(edge / radius);
    const double shell = 2.0 / 3.0 * base::kPi * (1.0 - std::cos(slope)) *
                         (std::pow(radius, 3) - std::pow(radius - depth, 3));
    const double wedge = 0.5 * depth * depth * std::tan(slope),
                 wedgeAt = edge - depth * std::sin(slope) / 3.0;
    const double closed = (isWhole ? 1.0 : 0.5) * (shell + 2.0 * base::kPi * wedgeAt * wedge);
    EXPECT_NEAR(geometry::volume(made.layered[0].solid), closed, (isWhole ? 0.02 : 0.06) * closed);
    EXPECT_NEAR(geometry::volume(made.rest) + geometry::volume(made.layered[0].solid),
                geometry::volume(part), 1e-3 * geometry::volume(part));
    const substrate::StackedLevels layers =
        layersOf(skin[0], made.layered[0], {part, made.rest}, kLevels, {});
    EXPECT_EQ(layers.stack.layerCount, 3);
    EXPECT_NEAR(test::volumeOf(layers.stack) / geometry::volume(made.layered[0].solid), 1.0, 0.03);
    for (const layers::Patch& patch : layers.stack.patches)
      for (const Vector3d& v : patch.surface.vertices)
        // Around corners of the painted surface its end is round.
        EXPECT_TRUE(isWhole || v.x() > -2.0 * depth) << v.transpose();
  }
}

TEST(PartRegions, FlatLayersFollowTheirDirection) {
  const TriangleMesh solid = test::box({0, 0, 10}, {16, 12, 26});
  const std::vector<project::Region> flat{{.shape = "height:10,26", .use = "flat:1,0,0"}};
  const substrate::StackedLevels layers =
      layersOf(flat[0], {0, solid}, {solid, solid}, kLevels, {});
  EXPECT_EQ(layers.stack.layerCount, 20);
  EXPECT_NEAR(test::volumeOf(layers.stack) / geometry::volume(solid), 1.0, 1e-3);
  for (const layers::Patch& patch : layers.stack.patches)
    EXPECT_TRUE(patch.direction.front().isApprox(Vector3d::UnitX()));
}

// Planes that turn fill a wedge: thickness grows with the distance from the line they turn about.
TEST(PartRegions, TurningLayersFillAWedge) {
  const double tilt = base::degreesToRadians(30.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> near(10.0, 25.0), width(4.0, 18.0);
  int refused = 0;
  for (int i = 0; i < 20; ++i) {
    const double r0 = near(random), r1 = r0 + width(random);
    // Between the plane z = 5 and one tilted about y through (0, 0, 5).
    TriangleMesh wedge = test::box({r0, -6, 5}, {r1, 6, 6});
    for (Vector3d& v : wedge.vertices)
      if (v.z() > 5.5)
        v = {v.x() * std::cos(tilt), v.y(), 5.0 + v.x() * std::sin(tilt)};
    const Vector3d direction(-std::sin(tilt), 0.0, std::cos(tilt));
    const std::vector<project::Region> turn{
        {.shape = "height:5,40",
         .use = "turn:" + std::to_string(direction.x()) + ",0," + std::to_string(direction.z())}};
    // The inner side is a chord.
    const double nearest = r0 * std::cos(0.5 * tilt);
    const bool fits = std::ceil(r1 * tilt / 1.0 - 1e-4) <= std::floor(nearest * tilt / 0.4 + 1e-4);
    try {
      const auto layers = layersOf(turn[0], {0, wedge}, {wedge, wedge}, kLevels, {});
      EXPECT_TRUE(fits) << r0 << " " << r1;
      EXPECT_NEAR(test::volumeOf(layers.stack) / geometry::volume(wedge), 1.0, 0.02);
      for (const layers::Patch& patch : layers.stack.patches)
        for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v) {
          const Vector3d& p = patch.surface.vertices[v];
          EXPECT_NEAR(patch.thicknessMm[v],
                      Vector3d(p.x(), 0.0, p.z() - 5.0).norm() * tilt / layers.stack.layerCount,
                      1e-3);
        }
    } catch (const base::Error&) {
      EXPECT_FALSE(fits) << r0 << " " << r1;
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 20);
}

// Bodies that touch up to rounding leave no film between them.
TEST(PartRegions, BodiesThatTouchLeaveNoFilm) {
  const TriangleMesh part = test::box({-10, -10, 0}, {10, 10, 30});
  const std::vector<project::Region> all{{.shape = "box:0,0,15,40,40,9.9999", .use = "flat"},
                                         {.shape = "box:0,0,25,40,40,10.0000", .use = "flat"}};
  const PartRegions made = divided({part}, all, kLevels, {});
  ASSERT_EQ(made.layered.size(), 2u);
  EXPECT_NEAR(geometry::bounds(made.rest).max().z(), 10.0, 0.001);
  EXPECT_EQ(geometry::components(made.rest).count, 1);
}

// Far finer than the step: blocks beside the rising wall are not left out.
TEST(PartRegions, ASkinOfAFineNozzleIsClosedAtAStep) {
  const substrate::LevelOptions fine{0.2, 0.1, 0.3, 0.0, 0.4};
  const TriangleMesh part = test::box({0, 0, 0}, {16, 8, 6}) + test::box({8, 0, 4}, {16, 8, 11.5});
  const std::vector<project::Region> skin{{.shape = "skin:2.4", .use = "surface"}};
  const PartRegions made = divided({part}, skin, fine, {});
  double mm3 = 0.0;
  for (const LayeredRegion& region : made.layered)
    mm3 += geometry::volume(region.solid);
  EXPECT_NEAR(mm3 / (2.0 * 8.0 * 8.0 * 2.4), 1.0, 0.03);
}

TEST(PartRegions, ASkinNeedsASurfaceAndACore) {
  const TriangleMesh part = test::box({0, 0, 0}, {20, 20, 5});
  const std::vector<project::Region> thick{{.shape = "skin:6", .use = "surface"}};
  EXPECT_THROW(divided({part}, thick, kLevels, {}), base::Error);
  TriangleMesh roof = test::box({0, 0, 0}, {4, 20, 20}); // steep sides only
  for (Vector3d& v : roof.vertices)
    if (v.z() > 1.0)
      v.x() = 2.0;
  const std::vector<project::Region> skin{{.shape = "skin:1,30", .use = "surface"}};
  EXPECT_THROW(divided({roof}, skin, kLevels, {}), base::Error);
  const std::vector<project::Region> film{{.shape = "skin:0.3", .use = "surface"}};
  EXPECT_THROW(divided({part}, film, kLevels, {}), base::Error);
}

} // namespace
} // namespace voluta::regions
