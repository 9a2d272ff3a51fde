// Level surfaces are at their distances, closed and facing outwards.
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/lathe_parts.h"
#include "helpers/shapes.h"
#include "published_flattening.h"
#include "substrate/levels.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace voluta {
namespace {

using Eigen::Vector3d;
using layers::LevelSurface;

// Manifold, consistently oriented against `direction`, attributes for every vertex. Returns the
// number of edges with one triangle.
std::size_t checkedRim(const LevelSurface& s) {
  const std::size_t n = s.surface.vertices.size();
  EXPECT_GT(s.surface.triangles.size(), 0u);
  EXPECT_EQ(s.thicknessMm.size(), n);
  EXPECT_EQ(s.direction.size(), n);
  EXPECT_EQ(s.clearDirection.size(), n);
  std::size_t rim = 0, wrong = 0;
  const auto edges = geometry::sortedHalfEdges(s.surface);
  geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
    rim += e - b == 1;
    wrong += e - b > 2 || (e - b == 2 && edges[b].forward == edges[b + 1].forward);
  });
  EXPECT_EQ(wrong, 0u);
  std::size_t turned = 0;
  for (std::size_t t = 0; t < s.surface.triangles.size(); ++t)
    turned += geometry::triangleArea(s.surface, t) > 1e-9 &&
              geometry::triangleNormal(s.surface, t)
                      .dot(s.direction[static_cast<std::size_t>(s.surface.triangles[t][0])]) <= 0.0;
  EXPECT_EQ(turned, 0u);
  return rim;
}

double farthest(const LevelSurface& s, const std::function<double(const Vector3d&)>& off) {
  double maximum = 0.0;
  for (const Vector3d& p : s.surface.vertices)
    maximum = std::max(maximum, std::abs(off(p)));
  return maximum;
}

double farthestMiddle(const LevelSurface& s, const std::function<double(const Vector3d&)>& off) {
  double maximum = 0.0;
  for (std::size_t t = 0; t < s.surface.triangles.size(); ++t)
    maximum = std::max(
        maximum,
        std::abs(
            off((s.surface.corner(t, 0) + s.surface.corner(t, 1) + s.surface.corner(t, 2)) / 3.0)));
  return maximum;
}

TEST(Levels, CylinderIsClosedAroundWithoutASeam) {
  for (const double r : {2.6, 5.0, 50.0}) {
    const LevelSurface s = substrate::cylinderLevel(r, 0.25, -25, 25, 0.7);
    const auto off = [r](const Vector3d& p) { return p.tail<2>().norm() - r; };
    const std::size_t rim = checkedRim(s);
    EXPECT_EQ(geometry::components(s.surface).count, 1);
    // Only the two ends.
    std::size_t ends = 0;
    for (const Vector3d& p : s.surface.vertices)
      ends += std::abs(p.x()) > 25 - 1e-9;
    EXPECT_EQ(rim, ends);
    EXPECT_LT(farthest(s, off), 1e-12 * r);
    EXPECT_LT(farthestMiddle(s, off), 0.0021);
    EXPECT_NEAR(geometry::area(s.surface) / (2 * base::kPi * r * 50), 1.0, 1e-3);
    ASSERT_EQ(s.chart.at.size(), s.surface.vertices.size());
    EXPECT_NEAR(s.chart.periodMm, 2 * base::kPi * r, 1e-12);
    for (std::size_t v = 0; v < s.direction.size(); ++v) {
      const double angle = s.chart.at[v].x() / r;
      EXPECT_LT((r * Vector3d(0, std::cos(angle), std::sin(angle)) +
                 s.chart.at[v].y() * Vector3d::UnitX() - s.surface.vertices[v])
                    .norm(),
                1e-9);
      EXPECT_LT(
          (r * s.direction[v] - Vector3d(0, s.surface.vertices[v].y(), s.surface.vertices[v].z()))
              .norm(),
          1e-9);
    }
  }
}

TEST(Levels, SphereCoversTheBox) {
  const Vector3d centre(1, 2, -10);
  const Eigen::AlignedBox3d box(Vector3d(-8, -6, 0), Vector3d(8, 6, 12));
  const LevelSurface s = substrate::sphereLevel(centre, 15, 0.3, box, 0.8);
  const auto off = [&](const Vector3d& p) { return (p - centre).norm() - 15; };
  EXPECT_GT(checkedRim(s), 0u);
  EXPECT_LT(farthest(s, off), 1e-12 * 15);
  EXPECT_LT(farthestMiddle(s, off), 0.0021);
  // Every point of the sphere in the box has a triangle under it.
  const geometry::MeshQuery query(s.surface);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 80; ++j) {
      const double a = base::kPi * i / 40, b = 2 * base::kPi * j / 80;
      const Vector3d p =
          centre + 15 * Vector3d(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      if (box.contains(p)) {
        EXPECT_LT(query.closest(p).distance, 0.0021);
      }
    }
  const LevelSurface whole = substrate::sphereLevel(
      centre, 15, 0.3, Eigen::AlignedBox3d(Vector3d::Constant(-90), Vector3d::Constant(90)), 0.8);
  EXPECT_EQ(checkedRim(whole), 0u);
  EXPECT_NEAR(geometry::area(whole.surface) / (4 * base::kPi * 225), 1.0, 1e-3);
  EXPECT_LT(s.surface.triangles.size(), whole.surface.triangles.size() / 2);
}

TEST(Levels, OffsetOfARoofIsRoundedOverItsRidge) {
  const geometry::TriangleMesh body = test::gableRoof(40, 60);
  const geometry::MeshQuery roof(body);
  const double top = 20 * std::sqrt(3.0);
  const Eigen::AlignedBox3d box(Vector3d(-4, -15, 8), Vector3d(4, 15, top + 4));
  const LevelSurface s =
      substrate::offsetLevel(substrate::distanceFrom(body), 1.35, 0.2, box, 0.4, {});
  checkedRim(s);
  EXPECT_LT(farthest(s, [&](const Vector3d& p) { return roof.signedDistance(p) - 1.35; }), 1e-9);
  // Chords over a cylinder of 1.35 mm that a grid of 0.4 mm gives.
  EXPECT_LT(farthestMiddle(s, [&](const Vector3d& p) { return roof.signedDistance(p) - 1.35; }),
            0.03);
  double highest = 0.0;
  for (std::size_t v = 0; v < s.direction.size(); ++v) {
    const Vector3d& p = s.surface.vertices[v];
    highest = std::max(highest, p.z());
    // Over the ridge directions point away from it, on the slopes across them.
    const Eigen::Vector2d d = s.direction[v].tail<2>();
    const Eigen::Vector2d fromRidge(p.y(), p.z() - top);
    if (fromRidge.y() > 0.5 * fromRidge.norm() + 1e-6)
      EXPECT_NEAR((fromRidge.normalized() - d).norm(), 0.0, 1e-6);
    else
      EXPECT_NEAR(d.y(), 0.5, 1e-6);
  }
  EXPECT_NEAR(highest, top + 1.35, 0.02);
}

TEST(Levels, OffsetDoesNotFoldInAValley) {
  // Two slopes of 45 degrees that meet at z = 0.
  geometry::TriangleMesh valley =
      test::drawnOut({{-20, -15, -5}, {-20, 0, -5}, {-20, 0, 0}, {-20, -15, 15}}, {40, 0, 0});
  test::append(valley, test::drawnOut({{-20, 15, -5}, {-20, 0, -5}, {-20, 0, 0}, {-20, 15, 15}},
                                      {40, 0, 0}));
  const LevelSurface s = substrate::offsetLevel(
      substrate::distanceFrom(valley), 3.0, 0.3,
      Eigen::AlignedBox3d(Vector3d(-5, -8, -1), Vector3d(5, 8, 14)), 0.5, {});
  checkedRim(s);
  // In the valley's middle the level is 3 sqrt 2 high; nothing of it comes nearer to a slope.
  for (const Vector3d& p : s.surface.vertices)
    EXPECT_NEAR((p.z() - std::abs(p.y())) / std::sqrt(2.0), 3.0, 1e-9);
}

TEST(Levels, CirclesMeetTopAndFoot) {
  for (const bool plane : {false, true}) {
    const auto c = plane ? substrate::flatteningToPlane({20, 20}, 7, 0.2, 10)
                         : test::flatteningCircles({20, 20}, 0.15, 0.3, 0.72, 10);
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      const LevelSurface s = substrate::circleLevel(c[k], c[k + 1], 7, -5, 5, 0.7);
      checkedRim(s);
      for (std::size_t v = 0; v < s.direction.size(); ++v) {
        const Vector3d half = 0.5 * s.thicknessMm[v] * s.direction[v];
        const Vector3d foot = s.surface.vertices[v] - half, tip = s.surface.vertices[v] + half;
        EXPECT_NEAR(std::hypot(foot.y(), foot.z() - (c[k].topMm - c[k].radiusMm)), c[k].radiusMm,
                    1e-9);
        if (c[k + 1].isPlane())
          EXPECT_NEAR(tip.z(), c[k + 1].topMm, 1e-9);
        else
          EXPECT_NEAR(std::hypot(tip.y(), tip.z() - (c[k + 1].topMm - c[k + 1].radiusMm)),
                      c[k + 1].radiusMm, 1e-9);
      }
    }
  }
}

} // namespace
} // namespace voluta
