// An open surface as one wall: thicknesses in closed form, rims that stay open, and refusals.
#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/self_intersections.h"
#include "geometry/repair/surface_wall.h"
#include "helpers/all_seeds.h"

#include <Eigen/Geometry>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace voluta::geometry {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

using Surface = std::function<Vector3d(double u, double v)>;

// A grid over [0, 1]^2; `around`: u = 1 is u = 0.
TriangleMesh gridOf(int nu, int nv, bool around, const Surface& at) {
  TriangleMesh m;
  const int columns = around ? nu : nu + 1;
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i < columns; ++i)
      m.vertices.push_back(at(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
  const auto index = [&](int i, int j) { return j * columns + i % columns; };
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      m.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      m.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return m;
}

// A cone frustum around z with these radii at its lower and upper rim.
TriangleMesh frustum(double lower, double upper, double height, int sides = 128) {
  return gridOf(sides, 6, true, [=](double u, double v) {
    const double r = lower + (upper - lower) * v, a = 2.0 * std::numbers::pi * u;
    return Vector3d(r * std::cos(a), r * std::sin(a), height * v);
  });
}

double radiusOf(const Vector3d& v) {
  return v.head<2>().norm();
}

std::string refusalOf(const TriangleMesh& mesh) {
  try {
    surfaceWall(mesh, {1.0}, {});
  } catch (const base::Error& error) {
    return error.what();
  }
  return {};
}

TEST(SurfaceWall, ATubeGetsTwoCoaxialSidesAndOpenRims) {
  const TriangleMesh wall = surfaceWall(frustum(15, 15, 20), {1.2}, {});
  EXPECT_TRUE(diagnose(wall).watertight);
  for (const Vector3d& v : wall.vertices)
    EXPECT_NEAR(std::abs(radiusOf(v) - 15.0), 0.6, 0.002);
  EXPECT_NEAR(volume(wall), area(frustum(15, 15, 20)) * 1.2, 1e-3 * volume(wall));
  EXPECT_NEAR(bounds(wall).min().z(), 0.0, 1e-9);
  EXPECT_NEAR(bounds(wall).max().z(), 20.0, 1e-9);
}

TEST(SurfaceWall, OfLevelLayersHasTheWidthInEverySection) {
  for (const double upper : {25.0, 15.0, 7.0}) {
    const TriangleMesh cone = frustum(15, upper, 12);
    const TriangleMesh wall = surfaceWall(cone, {1.2, 0.8}, {});
    ASSERT_EQ(wall.vertices.size(), 2 * cone.vertices.size());
    for (const Vector3d& v : wall.vertices) {
      const double at = 15.0 + (upper - 15.0) * v.z() / 12.0;
      EXPECT_NEAR(std::abs(radiusOf(v) - at), 0.6, 0.006);
      EXPECT_NEAR(v.z(), 2.0 * std::round(v.z() / 2.0), 0.006) << "rows stay level";
    }
  }
}

TEST(SurfaceWall, OfLevelLayersIsOneLayerThickWhereItIsLevel) {
  const TriangleMesh sheet =
      gridOf(8, 8, false, [](double u, double v) { return Vector3d(20 * u, 20 * v, 5); });
  const TriangleMesh wall = surfaceWall(sheet, {1.2, 0.8}, {});
  EXPECT_NEAR(volume(wall), 400 * 0.8, 0.01 * 400 * 0.8);
}

TEST(SurfaceWall, AFoldKeepsItsThicknessOnBothSides) {
  const TriangleMesh fold = gridOf(2, 1, false, [](double u, double v) {
    return u < 0.6 ? Vector3d(20 * u, 0, 10 * v) : Vector3d(10, 20 * (u - 0.5), 10 * v);
  });
  const TriangleMesh wall = surfaceWall(fold, {1.0}, {});
  EXPECT_TRUE(diagnose(wall).watertight);
  EXPECT_NEAR(volume(wall), 10 * (10 + 10) * 1.0, 0.5);
  EXPECT_NEAR(bounds(wall).min().y(), -0.5, 0.002);
  EXPECT_NEAR(bounds(wall).max().x(), 10.5, 0.002);
}

// Facets of any orientation, and those given twice.
TEST(SurfaceWall, OrientsTheSurfaceAndDropsItsSecondSide) {
  TriangleMesh tube = frustum(15, 15, 20);
  const double whole = volume(surfaceWall(tube, {1.2}, {}));
  for (std::size_t t = 0; t < tube.triangles.size(); t += 3)
    std::swap(tube.triangles[t][0], tube.triangles[t][1]);
  EXPECT_NEAR(volume(surfaceWall(tube, {1.2}, {})), whole, 1e-6);
  const std::size_t count = tube.triangles.size();
  for (std::size_t t = 0; t < count; ++t)
    tube.triangles.push_back({tube.triangles[t][0], tube.triangles[t][2], tube.triangles[t][1]});
  EXPECT_NEAR(volume(surfaceWall(tube, {1.2}, {})), whole, 1e-6);
}

TEST(SurfaceWall, ClosesHolesNarrowerThanTheWall) {
  TriangleMesh sheet =
      gridOf(40, 40, false, [](double u, double v) { return Vector3d(20 * u, 0, 20 * v); });
  sheet.triangles.erase(sheet.triangles.begin() + 1640);
  EXPECT_NEAR(volume(surfaceWall(sheet, {1.2}, {})), 400 * 1.2, 0.01 * 400 * 1.2);
  const TriangleMesh fine = surfaceWall(sheet, {0.4}, {});
  EXPECT_NEAR(volume(fine), (400 - 0.125) * 0.4, 0.002 * 400 * 0.4);
}

TEST(SurfaceWall, RefusesSurfacesWithoutTwoSides) {
  TriangleMesh tee =
      gridOf(4, 1, false, [](double u, double v) { return Vector3d(20 * u, 0, 10 * v); });
  const int n = static_cast<int>(tee.vertices.size());
  tee.vertices.emplace_back(10, 10, 0);
  tee.triangles.push_back({2, 7, n}); // the middle edge
  EXPECT_THAT(refusalOf(tee), HasSubstr("branches at 1 edges"));
  const TriangleMesh crossing = [] {
    TriangleMesh m =
        gridOf(3, 3, false, [](double u, double v) { return Vector3d(20 * u, 0, 20 * v); });
    TriangleMesh other = gridOf(
        3, 3, false, [](double u, double v) { return Vector3d(10.3, 20 * u - 9.7, 20 * v); });
    const int shift = static_cast<int>(m.vertices.size());
    m.vertices.insert(m.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
      m.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return m;
  }();
  EXPECT_THAT(refusalOf(crossing), HasSubstr("crosses itself"));
  // A band with half a twist
  TriangleMesh band = gridOf(40, 1, false, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, s = 4.0 * (v - 0.5);
    const double r = 20 + s * std::cos(0.5 * a);
    return Vector3d(r * std::cos(a), r * std::sin(a), s * std::sin(0.5 * a));
  });
  for (auto& t : band.triangles)
    for (int& v : t)
      v = v == 40 ? 41 : v == 81 ? 0 : v; // the last column is the first one upside down
  EXPECT_THAT(refusalOf(band), HasSubstr("only one side"));
}

// Waves of random direction, amplitude and mesh width.
TEST(SurfaceWall, RandomWavesHaveTheVolumeOfTheirAreaAndAreClosed) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < test::ofSeeds(30, 150); ++k) {
    const double amplitude = 2.0 * unit(random), waves = 0.5 + unit(random),
                 width = 0.4 + unit(random);
    const Eigen::Quaterniond rotation = Eigen::Quaterniond::UnitRandom();
    const int cells = 16 + static_cast<int>(10 * unit(random));
    const TriangleMesh sheet = gridOf(cells, cells, false, [&](double u, double v) {
      const double h = amplitude * std::sin(2 * std::numbers::pi * waves * u);
      return Vector3d(rotation * Vector3d(30 * u, 30 * v, h));
    });
    const TriangleMesh wall = surfaceWall(sheet, {width}, {});
    EXPECT_TRUE(diagnose(wall).watertight) << k;
    EXPECT_NEAR(volume(wall), area(sheet) * width, 0.02 * area(sheet) * width) << k;
  }
}

} // namespace
} // namespace voluta::geometry
