// The orientation of least residual projected area, on parts whose answer is known.
#include "placement/residual_area.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "placement/orient.h"
#include "placement/placement_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voluta::placement {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::meshOf;

const base::RunContext kQuiet;
constexpr double kDegree = base::degreesToRadians(1.0);

geometry::TriangleMesh rotated(geometry::TriangleMesh mesh, const Matrix3d& by) {
  for (Vector3d& v : mesh.vertices)
    v = by * v;
  return mesh;
}

Matrix3d about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Vector3d::Unit(axis)).toRotationMatrix();
}

bool anyway(const Matrix3d&) {
  return true;
}

// Semi-axes a, b of a prism along z.
geometry::TriangleMesh ellipse(double a, double b, double height, int around) {
  geometry::TriangleMesh m;
  for (const double z : {0.0, height})
    for (int i = 0; i < around; ++i) {
      const double t = 2.0 * base::kPi * i / around;
      m.vertices.emplace_back(a * std::cos(t), b * std::sin(t), z);
    }
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    m.triangles.push_back({i, j, around + j});
    m.triangles.push_back({i, around + j, around + i});
    if (i > 0 && j > 0) {
      m.triangles.push_back({0, j, i});
      m.triangles.push_back({around, around + i, around + j});
    }
  }
  return m;
}

TEST(ResidualArea, OfAnLIsItsNotch) {
  const auto mesh = meshOf(20, 20, 4, [](int i, int j, int) { return i < 5 || j < 5; });
  EXPECT_NEAR(outlineArea(mesh, xyPlane()), 175.0, 1e-6);
  EXPECT_NEAR(outlineArea(mesh, xzPlane()), 80.0, 1e-6);
  const ResidualAreas areas = residualAreas(mesh, Matrix3d::Identity());
  EXPECT_NEAR(areas.xyMm2, 225.0, 1e-6);
  EXPECT_NEAR(areas.xzMm2, 0.0, 1e-6);
  const ResidualRotation found = minResidualRotation(rotated(mesh, about(2, 20.0)), false, anyway);
  EXPECT_NEAR(found.after.xyMm2, 225.0, 1e-3);
  EXPECT_GT(found.before.xyMm2, 300.0);
}

TEST(ResidualArea, HolesCountAsEnclosed) {
  const auto ring =
      meshOf(9, 9, 3, [](int i, int j, int) { return i < 2 || i > 6 || j < 2 || j > 6; });
  EXPECT_NEAR(outlineArea(ring, xyPlane()), 81.0, 1e-6);
  EXPECT_NEAR(residualAreas(ring, Matrix3d::Identity()).xyMm2, 0.0, 1e-6);
}

TEST(ResidualArea, OfAnEllipseIsLeastAlongItsAxes) {
  const double a = 20.0, b = 8.0;
  const int around = 720;
  const auto mesh = ellipse(a, b, 5.0, around);
  const double area = 0.5 * around * std::sin(2.0 * base::kPi / around) * a * b;
  EXPECT_NEAR(outlineArea(mesh, xyPlane()), area, 1e-2);
  for (const double degrees : {0.0, 10.0, 33.0, 71.0}) {
    const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
    const double rectangle = 4.0 * std::hypot(a * c, b * s) * std::hypot(a * s, b * c);
    EXPECT_NEAR(residualAreas(mesh, about(2, degrees)).xyMm2, rectangle - area, 0.1) << degrees;
  }
  const ResidualRotation found = minResidualRotation(rotated(mesh, about(2, 33.0)), false, anyway);
  EXPECT_NEAR(found.after.xyMm2, 4.0 * a * b - area, 0.1);
  EXPECT_GE(found.tried, 360U);
}

TEST(ResidualArea, OfSolidsApartAddsUp) {
  auto mesh = test::box({0, 0, 0}, {4, 4, 4});
  test::append(mesh, test::box({6, 0, 1}, {10, 4, 5}));
  EXPECT_NEAR(outlineArea(mesh, xyPlane()), 32.0, 1e-6);
  test::append(mesh, test::box({1, 1, 10}, {9, 3, 12})); // above both
  EXPECT_NEAR(outlineArea(mesh, xyPlane()), 36.0, 1e-6);
}

TEST(ResidualArea, ATurnedBoxReturnsToItsAxes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> size(5.0, 60.0), angle(-90.0, 90.0);
  for (int i = 0; i < 300; ++i) {
    const Vector3d half(size(random), size(random), size(random));
    const Matrix3d by = about(2, angle(random));
    const auto mesh = rotated(test::box(-half, half), by);
    const ResidualRotation found = minResidualRotation(mesh, false, anyway);
    const Matrix3d back = found.rotation.toRotationMatrix() * by;
    // Each of the box's axes is along an axis again, to half of the finest step or the angle that
    // 0.2 % of the rectangle allow.
    EXPECT_LT((back - Matrix3d(back.array().round())).cwiseAbs().maxCoeff(), 2e-3) << i;
    EXPECT_LT(found.after.xyMm2, 0.002 * 4.0 * half.x() * half.y() + 1e-6) << i;
    EXPECT_LE(found.after.xzMm2, found.before.xzMm2 + 1e-3) << i;
  }
}

TEST(ResidualArea, ABoxLeaningAboutYIsSetUpright) {
  const auto mesh = rotated(test::box({-30, -10, -5}, {30, 10, 5}), about(1, 25.0));
  OrientOptions options;
  options.voxelMm = 1.0;
  const Orientation found = bestOrientation(mesh, Objective::MinResidualArea, options, kQuiet);
  EXPECT_FALSE(found.before.stands);
  EXPECT_TRUE(found.score.stands);
  EXPECT_NEAR(found.score.heightMm, 10.0, 0.02);
  EXPECT_NEAR(found.residual.xzMm2, 0.0, 0.2);
  EXPECT_GT(found.residualBefore.xzMm2, 500.0);
}

TEST(ResidualArea, UnstableRotationIsNotTaken) {
  // Along its axis on XZ, but with its tip on the plate.
  const auto cone = test::coneOnTip(10.0, 40.0, 32);
  const auto lying = rotated(cone, about(1, 90.0));
  const ResidualRotation found =
      minResidualRotation(lying, false, [](const Matrix3d&) { return false; });
  EXPECT_NEAR(found.after.xzMm2, found.before.xzMm2, 1e-9);
}

TEST(ResidualArea, APartAlongTheAxesStays) {
  const auto mesh = test::box({0, 0, 0}, {20, 10, 5});
  OrientOptions options;
  options.voxelMm = 1.0;
  for (const bool quarters : {false, true}) {
    options.quarterTurns = quarters;
    const Orientation found = bestOrientation(mesh, Objective::MinResidualArea, options, kQuiet);
    EXPECT_TRUE(found.rotation.isApprox(Eigen::Quaterniond::Identity()));
    EXPECT_NEAR(found.residual.xyMm2 + found.residual.xzMm2, 0.0, 1e-6);
  }
}

} // namespace
} // namespace voluta::placement
