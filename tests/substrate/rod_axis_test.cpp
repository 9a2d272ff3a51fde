#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "helpers/lathe_parts.h"
#include "helpers/shapes.h"
#include "substrate/rod_axis.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace voluta {
namespace {

geometry::TriangleMesh moved(geometry::TriangleMesh mesh, const Eigen::Isometry3d& by) {
  for (auto& p : mesh.vertices)
    p = by * p;
  return mesh;
}

Eigen::Isometry3d anywhere(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto next = [&] { return number(random); };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::Quaterniond(next(), next(), next(), next()).normalized().toRotationMatrix();
  pose.translation() = 80 * Eigen::Vector3d(next(), next(), next());
  return pose;
}

// Every vertex as far from the x axis as it was.
double maxOff(const geometry::TriangleMesh& placed, const geometry::TriangleMesh& original,
              double scale) {
  double maximum = 0.0;
  for (std::size_t v = 0; v < placed.vertices.size(); ++v)
    maximum = std::max(maximum, std::abs(placed.vertices[v].tail<2>().norm() -
                                         scale * original.vertices[v].tail<2>().norm()));
  return maximum;
}

TEST(RodAxis, IsFoundInAnyPoseOfThePart) {
  const geometry::TriangleMesh parts[] = {
      test::revolved(test::tubeSection(), 128),
      test::revolved(test::shoulderSection(), 100),
      test::revolved(test::taperedSection(), 64),
      test::hexagonalTube(5, 10, 50),
      test::revolved({{-1, 2.4}, {-1, 20}, {1, 20}, {1, 2.4}}, 128),
      geometry::TriangleMesh(test::box({-30, -4, -3}, {30, 4, 3}))};
  unsigned seed = 1;
  for (const auto& part : parts) {
    const Eigen::Isometry3d pose = anywhere(seed++);
    const auto turned = moved(part, pose);
    const auto fit = substrate::fitAxis(turned);
    const Eigen::Vector3d axis = pose.linear().col(0);
    EXPECT_NEAR(fit.direction.cross(axis).norm(), 0.0, 1e-6);
    EXPECT_NEAR(axis.cross(fit.point - pose.translation()).norm(), 0.0, 1e-6);
    EXPECT_GT(fit.sharpness, 1.5);
    for (const double scale : {1.0, 2.5}) {
      const auto placed =
          geometry::place(turned, scale, substrate::placementOnAxis(turned, scale, fit));
      EXPECT_LT(maxOff(placed, part, scale), 1e-6);
      const auto box = geometry::bounds(placed);
      EXPECT_NEAR(box.min().x() + box.max().x(), 0.0, 1e-9);
    }
  }
}

TEST(RodAxis, PartWithoutAnAxisIsRefused) {
  for (const auto& part : {test::box({0, 0, 0}, {10, 10, 10}), test::sphere({1, 2, 3}, 10)})
    try {
      substrate::fitAxis(part);
      FAIL();
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
      EXPECT_NE(std::string(e.what()).find("no clear axis"), std::string::npos);
    }
  EXPECT_THROW(substrate::fitAxis({}), base::Error);
}

} // namespace
} // namespace voluta
