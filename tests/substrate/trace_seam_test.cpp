// Seams on bodies whose outlines are known (Castelli 7.1.2), and beads along them.
#include "substrate/bead_strip.h"
#include "substrate/trace_seam.h"

#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace voluta::substrate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;

const base::RunContext kOne;

// A surface z(x, y) over a disc, facing up.
TriangleMesh surfaceOver(double radius, int rings, int sides,
                         const std::function<double(const Vector2d&)>& height,
                         const Vector2d& stretch = {1.0, 1.0}) {
  TriangleMesh mesh;
  const auto add = [&](const Vector2d& p) { mesh.vertices.emplace_back(p.x(), p.y(), height(p)); };
  add({0, 0});
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < sides; ++k) {
      const double angle = base::kTwoPi * k / sides, at = radius * r / rings;
      add({stretch.x() * at * std::cos(angle), stretch.y() * at * std::sin(angle)});
    }
  for (int k = 0; k < sides; ++k)
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % sides});
  for (int r = 1; r < rings; ++r)
    for (int k = 0; k < sides; ++k) {
      const int a = 1 + (r - 1) * sides + k, b = 1 + (r - 1) * sides + (k + 1) % sides;
      mesh.triangles.push_back({a, a + sides, b + sides});
      mesh.triangles.push_back({a, b + sides, b});
    }
  return mesh;
}

TriangleMesh cap(double radius, int rings = 60) {
  return surfaceOver(0.95 * radius, rings, 180, [radius](const Vector2d& p) {
    return std::sqrt(radius * radius - p.squaredNorm());
  });
}

// A spherical cap is 35 deg steep on a circle of radius R sin 35 deg.
TEST(Seam, OfASphereIsACircle) {
  const double radius = 40.0, steep = base::degreesToRadians(35.0);
  const std::vector<SeamCurve> seam = seamCurves(cap(radius), {}, kOne);
  ASSERT_EQ(seam.size(), 1u);
  const double length = base::kTwoPi * radius * std::sin(steep);
  EXPECT_NEAR(seam[0].lengthMm(), length, 0.003 * length);
  for (std::size_t i = 0; i < seam[0].points.size(); ++i) {
    const Vector3d& p = seam[0].points[i];
    EXPECT_NEAR(p.norm(), radius, 0.05);
    EXPECT_NEAR(p.head<2>().norm(), radius * std::sin(steep), 0.1);
    EXPECT_GT(seam[0].normals[i].dot(p.normalized()), std::cos(0.02));
  }
}

TEST(Seam, CopiesAreFurtherInside) {
  SeamRule rule;
  rule.insetMm = 2.0;
  rule.spacingMm = 3.0;
  rule.curves = 20; // more than there is room for
  const double outer = 40.0 * std::sin(rule.steepRad);
  const std::vector<SeamCurve> seams = seamCurves(cap(40.0), rule, kOne);
  ASSERT_EQ(seams.size(), 7u); // to a radius of 2.9
  for (std::size_t k = 0; k < seams.size(); ++k) {
    const double radius = outer - 2.0 - 3.0 * static_cast<double>(k);
    for (const Vector3d& p : seams[k].points)
      EXPECT_NEAR(p.head<2>().norm(), radius, 0.12);
  }
}

// The top of a box has sharp edges: the seam is its rim.
TEST(Seam, OfABoxIsTheRimOfItsTop) {
  const std::vector<SeamCurve> seam = seamCurves(test::box({-10, -6, 0}, {10, 6, 5}), {}, kOne);
  ASSERT_EQ(seam.size(), 1u);
  EXPECT_NEAR(seam[0].lengthMm(), 64.0, 0.1);
  for (const Vector3d& normal : seam[0].normals)
    EXPECT_NEAR(normal.z(), 1.0, 1e-9);
}

// The side of a box is vertical: a pass on it is the rim's copy further down.
TEST(Seam, SidePassesAreBelowTheOutline) {
  SeamRule rule;
  rule.curves = 0;
  rule.sideCurves = 2;
  rule.sideDepthMm = 1.5;
  rule.spacingMm = 2.0;
  const std::vector<SeamCurve> sides = seamCurves(test::box({-10, -6, 0}, {10, 6, 5}), rule, kOne);
  ASSERT_EQ(sides.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(sides[k].lengthMm(), 64.0, 0.1);
    for (std::size_t i = 0; i < sides[k].points.size(); ++i) {
      EXPECT_NEAR(sides[k].points[i].z(), k == 0 ? 3.5 : 1.5, 1e-6);
      EXPECT_NEAR(sides[k].normals[i].z(), 0.0, 1e-9);
    }
  }
}

// Below the 35 deg circle of a sphere, a side pass is a circle of latitude.
TEST(Seam, SidePassesOfASphereAreCircles) {
  const double radius = 40.0, depth = 4.0;
  SeamRule rule;
  rule.curves = 0;
  rule.sideCurves = 1;
  rule.sideDepthMm = depth;
  const std::vector<SeamCurve> sides = seamCurves(cap(radius), rule, kOne);
  ASSERT_EQ(sides.size(), 1u);
  const double z = radius * std::cos(rule.steepRad) - depth,
               length = base::kTwoPi * std::sqrt(radius * radius - z * z);
  EXPECT_NEAR(sides[0].lengthMm(), length, 0.005 * length);
  for (const Vector3d& p : sides[0].points)
    EXPECT_NEAR(p.z(), z, 0.1);
}

// Inside the first curve of a box of 20 x 12 there are 14 x 6 mm; lines across it are 6 mm long.
TEST(Seam, LinesFillBothEnds) {
  SeamRule rule;
  rule.minMm = 1.0;
  rule.fillLines = 2;
  const TriangleMesh box = test::box({-10, -6, 0}, {10, 6, 5});
  const std::vector<SeamCurve> curves = seamCurves(box, rule, kOne);
  ASSERT_EQ(curves.size(), 5u);
  const double at[] = {5.5, 2.5, -5.5, -2.5};
  for (std::size_t k = 1; k < curves.size(); ++k) {
    EXPECT_FALSE(curves[k].isClosed);
    EXPECT_NEAR(curves[k].lengthMm(), 6.0, 0.02);
    for (const Vector3d& p : curves[k].points)
      EXPECT_NEAR(p.x(), at[k - 1], 0.01);
  }
  // More than there is room for: lines 3 mm apart fill the length of 14 once.
  rule.fillLines = 100;
  EXPECT_EQ(seamCurves(box, rule, kOne).size(), 1u + 4u);
  rule.fillRad = 0.0; // along x
  EXPECT_EQ(seamCurves(box, rule, kOne).size(), 1u + 2u);
}

TEST(Seam, WithoutAGentleSurfaceThereIsNone) {
  const TriangleMesh roof =
      surfaceOver(20.0, 10, 60, [](const Vector2d& p) { return 60.0 - 2.0 * p.norm(); });
  EXPECT_TRUE(seamCurves(roof, {}, kOne).empty());
  EXPECT_TRUE(seamCurves({}, {}, kOne).empty());
}

// An upper like a shoe's: an ellipse whose crown turns down at the rim. Where a x^4 is 35 deg
// steep is known along both axes.
TEST(Seam, OfAnUpperFollowsItsShape) {
  const Vector2d stretch(1.0, 0.4);
  const auto height = [&](const Vector2d& p) {
    const double r2 = std::pow(p.x(), 2) + std::pow(p.y() / 0.4, 2);
    return 40.0 - 15.0 * std::pow(r2 / 1e4, 4);
  };
  const TriangleMesh upper = surfaceOver(110.0, 110, 240, height, stretch);
  const std::vector<SeamCurve> seam = seamCurves(upper, {}, kOne);
  ASSERT_EQ(seam.size(), 1u);
  // Along x: 15 * 8 x^7 / 100^8 = tan 35 deg.
  const double x = 100.0 * std::pow(100.0 * std::tan(SeamRule{}.steepRad) / 120.0, 1.0 / 7.0);
  double farthest = 0.0;
  for (const Vector3d& p : seam[0].points)
    farthest = std::max(farthest, p.x());
  EXPECT_NEAR(farthest, x, 0.2);
}

// Pappus: the strip around a circle on a plane has the volume of its section times its length.
// The normals of neighbouring triangles differ a little, so that the outline of a crown steps aside
// by a tenth of a millimetre; a strip along it must not fold there.
TEST(Seam, OfACrownHasNoSteps) {
  SeamRule rule;
  rule.stepMm = 2.0;
  rule.curves = 2;
  rule.spacingMm = 6.0;
  const TriangleMesh crown =
      surfaceOver(1.0, 90, 240,
                  [](const Vector2d& p) {
                    return 45.0 - 18.0 * std::pow(Vector2d(p.x() / 90.0, p.y() / 38.0).norm(), 6);
                  },
                  {90.0, 38.0});
  const std::vector<SeamCurve> seams = seamCurves(crown, rule, kOne);
  ASSERT_EQ(seams.size(), 2u);
  for (const SeamCurve& seam : seams)
    for (std::size_t i = 0, n = seam.points.size(); i < n; ++i) {
      const Vector3d before = seam.points[(i + 1) % n] - seam.points[i],
                     after = seam.points[(i + 2) % n] - seam.points[(i + 1) % n];
      EXPECT_GT(before.normalized().dot(after.normalized()), 0.97) << seam.points[i].transpose();
    }
}

TEST(BeadStrip, HasTheVolumeOfItsBead) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 100; ++k) {
    SeamCurve circle;
    const double radius = 8.0 + 30.0 * share(random);
    const int n = 120;
    for (int i = 0; i < n; ++i) {
      const double a = base::kTwoPi * i / n;
      circle.points.emplace_back(radius * std::cos(a), radius * std::sin(a), 3.0);
      circle.normals.emplace_back(0, 0, 1);
    }
    const StripSize size{1.0 + 4.0 * share(random), 0.3 + share(random)};
    const double volume = base::kTwoPi * radius * size.widthMm * size.heightMm;
    EXPECT_NEAR(geometry::volume(stripSolid(circle, size)), volume, 0.003 * volume);
    const layers::Patch patch = stripPatch(circle, size);
    double area = 0.0;
    for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
      area += geometry::triangleArea(patch.surface, t);
      const Vector3d normal = (patch.surface.corner(t, 1) - patch.surface.corner(t, 0))
                                  .cross(patch.surface.corner(t, 2) - patch.surface.corner(t, 0));
      ASSERT_GT(normal.z(), 0.0);
    }
    EXPECT_NEAR(area * size.heightMm, volume, 0.003 * volume);
  }
}

TEST(BeadStrip, OfAnOpenCurveHasEnds) {
  SeamCurve line;
  line.isClosed = false;
  for (int i = 0; i <= 10; ++i) {
    line.points.emplace_back(2.0 * i, 1.0, 3.0);
    line.normals.emplace_back(0, 0, 1);
  }
  EXPECT_NEAR(line.lengthMm(), 20.0, 1e-9);
  const StripSize size{3.0, 0.5};
  EXPECT_NEAR(geometry::volume(stripSolid(line, size)), 20.0 * 3.0 * 0.5, 1e-9);
  EXPECT_EQ(stripPatch(line, size).surface.triangles.size(), 20u);
}

} // namespace
} // namespace voluta::substrate
