// The pith of parts whose skeletons are known (TreeD printing, Castelli 6.4.4).
#include "planar/pith_body.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;

// A round rod from one point to another, with rings along it so that the flow has vertices.
geometry::TriangleMesh rod(const Vector3d& from, const Vector3d& to, double radius) {
  constexpr int kSides = 32, kRings = 24;
  const Vector3d along = (to - from).normalized(), u = along.unitOrthogonal(), v = along.cross(u);
  geometry::TriangleMesh mesh;
  for (int ring = 0; ring <= kRings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const double a = base::kTwoPi * k / kSides;
      mesh.vertices.push_back(from + (to - from) * ring / kRings +
                              radius * (std::cos(a) * u + std::sin(a) * v));
    }
  for (int ring = 0; ring < kRings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const int a = ring * kSides + k, b = ring * kSides + (k + 1) % kSides;
      mesh.triangles.push_back({a, b, b + kSides});
      mesh.triangles.push_back({a, b + kSides, a + kSides});
    }
  const int low = static_cast<int>(mesh.vertices.size()), last = kRings * kSides;
  mesh.vertices.push_back(from);
  mesh.vertices.push_back(to);
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    mesh.triangles.push_back({low, next, k});
    mesh.triangles.push_back({low + 1, last + k, last + next});
  }
  return mesh;
}

geometry::TriangleMesh joined(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  return geometry::meshBoolean(geometry::BooleanOperation::Union, a, b, false).value();
}

// A trunk of 40 mm with two branches of 40 mm at 40 degrees to it.
geometry::TriangleMesh tree(double radius) {
  const Vector3d fork(0, 0, 40);
  const double lean = base::degreesToRadians(40.0);
  geometry::TriangleMesh mesh = rod({0, 0, 0}, fork, radius);
  for (const double side : {-1.0, 1.0})
    mesh = joined(mesh, rod(fork - Vector3d(0, 0, 2),
                            fork + 40.0 * Vector3d(side * std::sin(lean), 0.01, std::cos(lean)),
                            radius - 0.05));
  return mesh;
}

TEST(PithBody, OfARodIsAThinnerRod) {
  PithRule rule;
  rule.share = 0.4;
  const PithBody body = pithBody(rod({0, 0, 0}, {0, 0, 60}, 8.0), rule, {});
  EXPECT_EQ(body.limbs, 1);
  EXPECT_NEAR(body.lengthMm, 60.0, 0.5);
  EXPECT_NEAR(body.minRadiusMm, 3.2, 0.1);
  EXPECT_NEAR(body.maxRadiusMm, 3.2, 0.1);
  const double volume = base::kPi * 3.2 * 3.2 * 60.0;
  EXPECT_NEAR(geometry::volume(body.mesh), volume, 0.05 * volume);
  // It reaches both ends and is cut there.
  const Eigen::AlignedBox3d box = geometry::bounds(body.mesh);
  EXPECT_NEAR(box.min().z(), 0.0, 1e-6);
  EXPECT_NEAR(box.max().z(), 60.0, 1e-6);
}

TEST(PithBody, OfATreeBranchesAndIsThickerThere) {
  const geometry::TriangleMesh part = tree(6.0);
  PithRule rule;
  rule.share = 0.4;
  rule.minRadiusMm = 1.0;
  const PithBody body = pithBody(part, rule, {});
  EXPECT_EQ(body.limbs, 3);
  EXPECT_EQ(geometry::components(body.mesh).count, 1);
  EXPECT_NEAR(body.lengthMm, 120.0, 8.0);
  EXPECT_GT(body.maxRadiusMm, 1.25 * body.minRadiusMm);
  // It is within the part.
  const geometry::MeshQuery whole(part);
  for (const Vector3d& vertex : body.mesh.vertices)
    EXPECT_LT(whole.signedDistance(vertex), 1e-3);
  // Its ends are those of the branches.
  const geometry::MeshQuery query(body.mesh);
  const double lean = base::degreesToRadians(40.0);
  for (const double side : {-1.0, 1.0})
    EXPECT_TRUE(query.inside(Vector3d(0, 0, 40) +
                             38.5 * Vector3d(side * std::sin(lean), 0.01, std::cos(lean))));
}

// A T of square bars with the long triangles of CAD.
geometry::TriangleMesh tee() {
  return joined(test::box({-4, -4, 0}, {4, 4, 41}), test::box({-40, -3.9, 40}, {40, 3.9, 48}));
}

TEST(PithBody, OfLongTrianglesHasAllLimbs) {
  const PithBody body = pithBody(tee(), {}, {});
  EXPECT_EQ(body.limbs, 3);
  EXPECT_NEAR(body.lengthMm, 80.0 + 44.0, 6.0);
  const geometry::MeshQuery query(body.mesh);
  EXPECT_TRUE(query.inside(Vector3d(0, 0, 1.5)));
  EXPECT_TRUE(query.inside(Vector3d(-38, 0, 44)));
  EXPECT_TRUE(query.inside(Vector3d(38, 0, 44)));
}

// A shaft with a wide gear (24 teeth) between its ends.
TEST(PithBody, OfAShaftWithAGearIsARod) {
  constexpr int kTeeth = 24;
  geometry::TriangleMesh gear;
  for (const double z : {20.0, 30.0})
    for (int k = 0; k < 2 * kTeeth; ++k) {
      const double angle = 0.5 * base::kTwoPi * k / kTeeth, radius = k % 2 == 0 ? 14.0 : 11.0;
      gear.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  const int low = 4 * kTeeth, high = low + 1;
  gear.vertices.emplace_back(0, 0, 20);
  gear.vertices.emplace_back(0, 0, 30);
  for (int k = 0; k < 2 * kTeeth; ++k) {
    const int a = k, b = (k + 1) % (2 * kTeeth), up = 2 * kTeeth;
    gear.triangles.push_back({low, b, a});
    gear.triangles.push_back({high, a + up, b + up});
    gear.triangles.push_back({a, b, b + up});
    gear.triangles.push_back({a, b + up, a + up});
  }
  const PithBody body = pithBody(joined(gear, test::box({-5, -5, 0}, {5, 5, 70})), {}, {});
  EXPECT_GE(body.limbs, 1);
  const geometry::MeshQuery query(body.mesh);
  for (const double z : {2.0, 15.0, 25.0, 35.0, 68.0})
    EXPECT_TRUE(query.inside(Vector3d(0, 0, z))) << z;
}

TEST(PithBody, AnOpenPartIsRefused) {
  geometry::TriangleMesh open = test::box({0, 0, 0}, {10, 10, 40});
  open.triangles.pop_back();
  EXPECT_THROW(pithBody(open, {}, {}), base::Error);
}

} // namespace
} // namespace voluta::planar
