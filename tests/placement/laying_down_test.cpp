// Parts on their side in a block, from any orientation.
#include "placement/laying_down.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::placement {
namespace {

using Eigen::Vector3d;

geometry::TriangleMesh rotated(geometry::TriangleMesh mesh, const Eigen::Quaterniond& by) {
  for (Vector3d& v : mesh.vertices)
    v = by * v;
  return mesh;
}

// A piece of a hollow sphere over a rectangle, as a piece of a skull.
geometry::TriangleMesh shell(double radius, double thickness, double alongX, double alongY) {
  constexpr int kAlong = 24;
  geometry::TriangleMesh m;
  for (const double r : {radius, radius + thickness})
    for (int j = 0; j <= kAlong; ++j)
      for (int i = 0; i <= kAlong; ++i) {
        const double x = alongX * (1.0 * i / kAlong - 0.5), y = alongY * (1.0 * j / kAlong - 0.5);
        m.vertices.push_back(r * Vector3d(x, y, std::sqrt(radius * radius - x * x - y * y)) /
                             radius);
      }
  const int row = kAlong + 1, upper = row * row;
  const auto quad = [&](int a, int b, int c, int d) {
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < kAlong; ++j)
    for (int i = 0; i < kAlong; ++i) {
      const int a = j * row + i;
      quad(a, a + row, a + row + 1, a + 1);
      quad(upper + a, upper + a + 1, upper + a + row + 1, upper + a + row);
    }
  const auto wall = [&](int a, int b) { quad(a, b, upper + b, upper + a); };
  for (int i = 0; i < kAlong; ++i) {
    wall(i, i + 1);
    wall(kAlong * row + i + 1, kAlong * row + i);
    wall((i + 1) * row, i * row);
    wall(i * row + kAlong, (i + 1) * row + kAlong);
  }
  return m;
}

Vector3d sizesOf(const geometry::TriangleMesh& mesh, const MillingOrientation& orientation) {
  return geometry::bounds(rotated(mesh, orientation.rotation)).sizes();
}

// The search may end in another orientation in which all rectangles are parallel to the axes.
TEST(LayingDown, ABoxIsParallelToItsBlock) {
  constexpr int kBoxes = 60, kMinParallel = 58;
  std::mt19937 random(4);
  std::normal_distribution<double> part;
  const Vector3d wanted(40.0, 22.0, 9.0);
  const geometry::TriangleMesh box = test::box({0, 0, 0}, wanted);
  int parallel = 0;
  for (int k = 0; k < kBoxes; ++k) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(part(random), part(random), part(random), part(random)).normalized();
    const geometry::TriangleMesh mesh = rotated(box, rotation);
    const MillingOrientation orientation = millingOrientation(mesh);
    const Vector3d sizes = sizesOf(mesh, orientation);
    parallel += (sizes - wanted).cwiseAbs().maxCoeff() < 0.1 ? 1 : 0;
    EXPECT_LE(orientation.rounds, 10);
    EXPECT_NEAR(orientation.scrapMm3, sizes.prod() - wanted.prod(), 1e-3);
    EXPECT_LE(orientation.scrapMm3, orientation.scrapBeforeMm3 + 1e-9);
  }
  EXPECT_GE(parallel, kMinParallel);
}

TEST(LayingDown, ShellIsTurnedOnItsSide) {
  std::mt19937 random(9);
  std::normal_distribution<double> part;
  const geometry::TriangleMesh upright = shell(50.0, 9.0, 34.0, 26.0);
  ASSERT_GT(geometry::volume(upright), 0.0);
  const Vector3d best = geometry::bounds(upright).sizes();
  for (int k = 0; k < 40; ++k) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(part(random), part(random), part(random), part(random)).normalized();
    const geometry::TriangleMesh mesh = rotated(upright, rotation);
    const Vector3d sizes = sizesOf(mesh, millingOrientation(mesh));
    EXPECT_LT(sizes.prod(), 1.02 * best.prod()) << k;
    EXPECT_GE(sizes.x(), sizes.y());
    EXPECT_GE(sizes.y(), sizes.z());
  }
}

TEST(LayingDown, WellOrientedPartIsKept) {
  const MillingOrientation orientation = millingOrientation(test::box({0, 0, 0}, {30, 20, 10}));
  EXPECT_NEAR(orientation.rotation.angularDistance(Eigen::Quaterniond::Identity()), 0.0, 1e-12);
  EXPECT_NEAR(orientation.scrapMm3, 0.0, 1e-6);
  const geometry::TriangleMesh upright = test::box({0, 0, 0}, {10, 20, 30});
  EXPECT_NEAR(sizesOf(upright, millingOrientation(upright)).z(), 10.0, 1e-6);
}

} // namespace
} // namespace voluta::placement
