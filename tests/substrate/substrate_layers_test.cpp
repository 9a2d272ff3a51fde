// Layers on given surfaces against volumes, thicknesses and places in closed form.
#include "base/error.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/placement.h"
#include "helpers/all_seeds.h"
#include "helpers/lathe_parts.h"
#include "helpers/layer_volume.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "layers/layer_checks.h"
#include "substrate/substrate_layers.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace voluta {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using geometry::TriangleMesh;
using substrate::GroundDistance;
using substrate::LevelShape;
using substrate::StackedLevels;
using substrate::SubstrateOptions;

constexpr double kHatch = 0.657079633; // table 5.1, h 0.2
constexpr double kWidth = 10 * kHatch, kFirst = 0.25, kHeight = 0.2, kAll = kFirst + 9 * kHeight;

// Table 5.1 of Castelli 2020.
SubstrateOptions tableOptions(LevelShape shape) {
  SubstrateOptions o;
  o.layerHeightMm = kHeight;
  o.firstLayerMm = kFirst;
  o.shape = shape;
  return o;
}

void expectExactBoundaries(const layers::LayerStack& stack, const TriangleMesh& part) {
  const geometry::MeshQuery query(part);
  for (const auto& check : layers::checkBoundaries(stack, query, 1e-3, {})) {
    EXPECT_LE(check.farthestMm, 1e-3);
    EXPECT_EQ(check.onSurface, 1.0);
    EXPECT_TRUE(check.simple);
  }
}

StackedLevels layersOf(const TriangleMesh& part, const GroundDistance& ground, double volumeMm3,
                       const SubstrateOptions& o) {
  const substrate::LevelFamily family = substrate::substrateLevels(part, ground, o, {});
  StackedLevels made = substrate::stackLevels(part, family, o, {});
  EXPECT_NEAR(test::volumeOf(made.stack) / volumeMm3, 1.0, 1e-3);
  expectExactBoundaries(made.stack, part);
  EXPECT_EQ(made.unsupportedPatches, 0u);
  EXPECT_EQ(made.slivers, 0u);
  EXPECT_TRUE(made.findings.empty());
  for (const auto& check : layers::checkSupport(made.stack, 1.25, {}, {}, family.ground))
    EXPECT_GT(check.supportedFraction, 0.95);
  return made;
}

// Calls body(p, direction, thickness, way down to the patch below) at vertices inside a patch of a
// stack with one patch a layer.
template <typename Body> void forEachInside(const layers::LayerStack& stack, const Body& body) {
  for (std::size_t k = 1; k < stack.patches.size(); ++k) {
    const layers::Patch& patch = stack.patches[k];
    const geometry::MeshQuery below(stack.patches[k - 1].surface);
    std::vector<bool> isRim(patch.surface.vertices.size(), false);
    for (const auto& loop : geometry::boundaryLoops(patch.surface))
      for (int v : loop)
        isRim[static_cast<std::size_t>(v)] = true;
    for (std::size_t v = 0; v < isRim.size(); ++v) {
      const Vector3d &p = patch.surface.vertices[v], &d = patch.direction[v];
      const auto hit = isRim[v] ? std::nullopt : below.firstHit(p, p - d);
      if (hit)
        body(k, p, d, patch.thicknessMm[v], hit->t);
    }
  }
}

TEST(SubstrateLayers, RibOverAGableRoof) {
  const TriangleMesh roof = test::gableRoof(40, 30);
  const TriangleMesh rib = substrate::partOnBody(test::gableRib(40, kWidth, kAll, 8), roof);
  const auto made =
      layersOf(rib, substrate::distanceFrom(roof), test::gableRibVolume(40, kWidth, kAll, 8),
               tableOptions(LevelShape::Offset));
  ASSERT_EQ(made.stack.layerCount, 10);
  ASSERT_EQ(made.stack.patches.size(), 10u);
  const double top = 20 * std::sqrt(3.0);
  std::size_t seen = 0;
  forEachInside(made.stack, [&](std::size_t k, const Vector3d& p, const Vector3d&, double thickness,
                                double distance) {
    // Over the slopes; chords over the ridge are those of the grid.
    if (std::abs(p.y()) < 0.5 * (p.z() - top + std::abs(p.y()) * std::sqrt(3.0)) + 1.0)
      return;
    ++seen;
    EXPECT_NEAR(thickness / kHeight, 1.0, 5e-3);
    EXPECT_NEAR(distance / (k == 1 ? 0.5 * (kFirst + kHeight) : kHeight), 1.0, 5e-3);
    const double over = 0.5 * (std::sqrt(3.0) * std::abs(p.y()) + p.z() - top);
    EXPECT_NEAR(over, kFirst + kHeight * (static_cast<double>(k) - 0.5), 1e-3);
  });
  EXPECT_GT(seen, 5000u);
}

class HalfCylinderRib : public ::testing::TestWithParam<LevelShape> {};
TEST_P(HalfCylinderRib, HasLayersOfTheTable) {
  const TriangleMesh body = test::halfCylinder(40, 30, 361);
  const double from = 0.7, angle = base::kPi - 2 * from;
  const TriangleMesh rib =
      substrate::partOnBody(test::halfCylinderRib(40, kWidth, kAll, from, 361), body);
  const double volume = kWidth * angle * (std::pow(20 + kAll, 2) - 400) / 2;
  const auto made = layersOf(rib, substrate::distanceFrom(body), volume, tableOptions(GetParam()));
  ASSERT_EQ(made.stack.patches.size(), 10u);
  std::size_t seen = 0;
  forEachInside(made.stack, [&](std::size_t k, const Vector3d& p, const Vector3d&, double thickness,
                                double distance) {
    ++seen;
    EXPECT_NEAR(thickness / kHeight, 1.0, 5e-3);
    EXPECT_NEAR(distance / (k == 1 ? 0.5 * (kFirst + kHeight) : kHeight), 1.0, 2e-2);
    EXPECT_NEAR(p.tail<2>().norm(), 20 + kFirst + kHeight * (static_cast<double>(k) - 0.5), 2e-3);
  });
  EXPECT_GT(seen, 1000u);
}
INSTANTIATE_TEST_SUITE_P(Shapes, HalfCylinderRib,
                         ::testing::Values(LevelShape::Cylinder, LevelShape::Offset));

// A pentagonal prism around z, standing through a half cylinder of radius 20, its top at z = 23.
TriangleMesh pentagon() {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * base::kPi * i / 5 + 0.3;
    corners.emplace_back(10 * std::cos(a), 10 * std::sin(a), 14);
  }
  return test::drawnOut(corners, {0, 0, 9});
}

// Of the pentagon over the cylinder, by sections of constant y.
double pentagonVolume() {
  constexpr int kSteps = 200000;
  std::vector<Vector2d> corners;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * base::kPi * i / 5 + 0.3;
    corners.emplace_back(10 * std::cos(a), 10 * std::sin(a));
  }
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double y = -10 + 20 * (i + 0.5) / kSteps;
    double low = 1e9, high = -1e9;
    for (int k = 0; k < 5; ++k) {
      const Vector2d a = corners[static_cast<std::size_t>(k)],
                     b = corners[static_cast<std::size_t>((k + 1) % 5)];
      if ((a.y() <= y) == (b.y() <= y))
        continue;
      const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (high > low)
      sum += 20.0 / kSteps * (high - low) * (23 - std::sqrt(400 - y * y));
  }
  return sum;
}

TEST(SubstrateLayers, PentagonOnAHalfCylinderFlattens) {
  const TriangleMesh body = test::halfCylinder(40, 30, 361);
  const TriangleMesh part = substrate::partOnBody(pentagon(), body);
  SubstrateOptions o = tableOptions(LevelShape::Flatten);
  o.firstLayerMm = 0.0;
  const auto made = layersOf(part, substrate::distanceFrom(body), pentagonVolume(), o);
  EXPECT_EQ(made.statistics.withinLimitsFraction, 1.0);
  const int n = made.stack.layerCount;
  ASSERT_EQ(made.stack.patches.size(), static_cast<std::size_t>(n));
  // The circles, worked out again: sagittas over the part's width go down to 0 by equal steps.
  double b = 0.0;
  for (const Vector3d& p : part.vertices)
    b = std::max(b, std::abs(p.y()));
  const double sagitta = 20 - std::sqrt(400 - b * b);
  const auto radius = [&](int k) {
    const double s = sagitta * (n - k) / n;
    return (b * b + s * s) / (2 * s);
  };
  // From circle k along its radius to the next (Castelli 2020, 5.2.3), by halving an interval.
  const auto thickness = [&](int k, double alpha) {
    const double r = radius(k), centre = 20 + 3.0 * k / n - r;
    double low = 0.0, high = 2.0;
    for (int i = 0; i < 60; ++i) {
      const double h = 0.5 * (low + high);
      const double y = (r + h) * std::cos(alpha), z = centre + (r + h) * std::sin(alpha);
      const bool beyond =
          k + 1 == n ? z > 23
                     : std::hypot(y, z - (20 + 3.0 * (k + 1) / n - radius(k + 1))) > radius(k + 1);
      (beyond ? high : low) = h;
    }
    return low;
  };
  double thinnest = 1.0, thickest = 0.0;
  std::size_t seen = 0, farOff = 0;
  forEachInside(made.stack, [&](std::size_t k, const Vector3d& p, const Vector3d& d, double t,
                                double distance) {
    const int layer = static_cast<int>(k);
    const double r = radius(layer), centre = 20 + 3.0 * layer / n - r;
    const double alpha = std::atan2(p.z() - centre, p.y());
    const double h = thickness(layer, alpha);
    ++seen;
    EXPECT_NEAR(t / h, 1.0, 5e-3);
    EXPECT_NEAR(std::hypot(p.y(), p.z() - centre) - r, 0.5 * h, 2e-3);
    // Down to the middle of the layer below: half of either.
    const double lower = 20 + 3.0 * (layer - 1) / n - radius(layer - 1);
    const Vector3d foot = p - 0.5 * h * d;
    const double under = thickness(layer - 1, std::atan2(foot.z() - lower, foot.y()));
    const double off = std::abs(distance / (0.5 * (h + under)) - 1.0);
    EXPECT_LT(off, 1e-2);
    farOff += off > 5e-3; // by the chords of triangles
    thinnest = std::min(thinnest, t);
    thickest = std::max(thickest, t);
  });
  EXPECT_GT(seen, 10000u);
  EXPECT_LT(static_cast<double>(farOff), 5e-3 * static_cast<double>(seen));
  EXPECT_GT(thickest / thinnest, 1.3); // they do vary
}

TEST(SubstrateLayers, BlendDividesTheWayToAnEndSurface) {
  // From a plate at z = 10 to a roof that rises from 3 to 4.5 mm over it.
  const TriangleMesh body = test::box({-30, -30, 0}, {30, 30, 10});
  const TriangleMesh end =
      test::drawnOut({{-20, -20, 13}, {-20, -20, 20}, {20, -20, 20}, {20, -20, 14.5}}, {0, 40, 0});
  const TriangleMesh part = test::drawnOut(
      {{-8, -5, 10}, {8, -5, 10}, {8, -5, 10 + 3.75 + 0.3}, {-8, -5, 10 + 3.75 - 0.3}}, {0, 10, 0});
  SubstrateOptions o;
  o.shape = LevelShape::Flatten;
  o.end.mesh = std::make_shared<geometry::MeshQuery>(end);
  const auto made = layersOf(part, substrate::distanceFrom(body), 16 * 10 * 3.75, o);
  EXPECT_EQ(made.stack.layerCount, 15);
  forEachInside(made.stack, [&](std::size_t k, const Vector3d& p, const Vector3d& d, double t,
                                double distance) {
    const double h = (3.75 + 0.0375 * p.x()) / 15;
    EXPECT_NEAR(t / h, 1.0, 5e-3);
    EXPECT_NEAR(distance / h, 1.0, 5e-3);
    EXPECT_NEAR(p.z(), 10 + (static_cast<double>(k) + 0.5) * h, 2e-3);
    EXPECT_NEAR(d.z(), 1.0, 1e-6);
  });
}

void expectRefusal(const TriangleMesh& part, const TriangleMesh& body, const SubstrateOptions& o,
                   const std::string& what) {
  try {
    const TriangleMesh left = substrate::partOnBody(part, body);
    substrate::stackLevels(
        left, substrate::substrateLevels(left, substrate::distanceFrom(body), o, {}), o, {});
    ADD_FAILURE() << what;
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput) << e.what();
    EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_FALSE(e.remedy().empty());
  }
}

TEST(SubstrateLayers, BadInputGivesAnErrorOfOneLine) {
  const TriangleMesh plate = test::box({-30, -30, 0}, {30, 30, 10});
  const TriangleMesh inside = test::box({-5, -5, 2}, {5, 5, 8});
  expectRefusal(inside, plate, {}, "contains the whole part");
  expectRefusal(test::box({-5, -5, 10}, {5, 5, 10.05}), plate, {}, "less than a layer of 0.1 mm");
  expectRefusal(test::box({-5, -5, 20}, {5, 5, 24}), plate, {}, "the part misses the surface");
  TriangleMesh open = test::box({-5, -5, 8}, {5, 5, 14});
  open.triangles.pop_back();
  expectRefusal(open, plate, {}, "not closed");
  SubstrateOptions flatten;
  flatten.shape = LevelShape::Flatten;
  flatten.end.heightMm = 9.0;
  expectRefusal(test::box({-5, -5, 8}, {5, 5, 14}), plate, flatten, "hits the end surface");
  flatten.end.heightMm = 14.0;
  flatten.end.radiusMm = 50.0;
  expectRefusal(test::box({-5, -5, 8}, {5, 5, 14}), plate, flatten, "requires a cylinder along x");
  // From a cylinder to a plane over all its width: as thin at the top as it is thick at the sides.
  SubstrateOptions flat;
  flat.shape = LevelShape::Flatten;
  expectRefusal(test::box({-5, -18, 5}, {5, 18, 21}), test::halfCylinder(40, 30), flat,
                "no number of layers");
}

TEST(SubstrateLayers, RaysThatCrossInAHollowAreRefused) {
  // A trough of radius 5 in a block; layers of rays up to 8 mm over its bottom would fold.
  std::vector<Vector3d> section{{-20, 12, 0}, {-20, 12, 10}};
  for (const Vector2d& p : test::arc(5, 0, base::kPi, 91))
    section.emplace_back(-20, p.x(), 10 - p.y());
  section.emplace_back(-20, -12, 10);
  section.emplace_back(-20, -12, 0);
  std::vector<Vector2d> inner, outer;
  for (std::size_t i = 0; i < section.size(); ++i)
    inner.emplace_back(section[i].y(), section[i].z());
  for (const Vector2d& p : inner)
    outer.emplace_back(p.x(), std::min(p.y(), 0.0) - 2.0);
  const TriangleMesh trough = test::shell(inner, outer, -20, 20, false);
  const TriangleMesh part = test::box({-4, -3, 4}, {4, 3, 13});
  SubstrateOptions o;
  o.shape = LevelShape::Flatten;
  o.heightMinMm = 0.01;
  o.heightMaxMm = 2.0;
  o.end.heightMm = 13.0;
  expectRefusal(part, trough, o, "would fold");
}

// Spheres about a centre under the plate.
void layOnSpheres(const char* model) {
  VOLUTA_MODEL_OR_SKIP(file, model);
  const TriangleMesh part = geometry::place(geometry::readMesh(file).mesh, 0.5, {});
  SubstrateOptions o;
  o.layerHeightMm = 0.8;
  o.heightMinMm = 0.4;
  o.heightMaxMm = 1.0;
  o.beadWidthMm = 1.2;
  o.shape = LevelShape::Sphere;
  const substrate::LevelFamily family =
      substrate::substrateLevels(part, substrate::plateGround(), o, {});
  const StackedLevels made = substrate::stackLevels(part, family, o, {});
  expectExactBoundaries(made.stack, part);
  EXPECT_NEAR((test::volumeOf(made.stack) + made.sliverVolumeMm3) / geometry::volume(part), 1.0,
              5e-3);
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const Vector3d centre(0, 0, -0.5 * box.sizes().z());
  const double height = made.statistics.thicknessMeanMm;
  for (const layers::Patch& patch : made.stack.patches)
    for (std::size_t v = 0; v < patch.direction.size(); ++v) {
      const Vector3d out = (patch.surface.vertices[v] - centre).normalized();
      EXPECT_GT(out.dot(patch.direction[v]), 1 - 1e-5);
    }
  // Every place of the part is in some layer: half a height from a middle, or next to a rim.
  std::vector<geometry::MeshQuery> middles;
  for (const layers::Patch& patch : made.stack.patches)
    middles.emplace_back(patch.surface);
  const geometry::MeshQuery query(part);
  std::size_t inside = 0, covered = 0;
  for (double x = box.min().x(); x < box.max().x(); x += 2.7)
    for (double y = box.min().y(); y < box.max().y(); y += 2.7)
      for (double z = box.min().z(); z < box.max().z(); z += 2.7) {
        const Vector3d p(x, y, z);
        if (query.signedDistance(p) > -1.0)
          continue;
        ++inside;
        covered += std::any_of(middles.begin(), middles.end(), [&](const auto& middle) {
          return middle.closest(p, 0.51 * height).triangle >= 0;
        });
      }
  EXPECT_GT(inside, 300u);
  EXPECT_GT(static_cast<double>(covered), 0.999 * static_cast<double>(inside));
}
TEST(SubstrateLayers, SpheresCoverRealParts) {
  layOnSpheres("spot.stl");
  if (test::allSeeds())
    layOnSpheres("kitten.stl");
}

} // namespace
} // namespace voluta
