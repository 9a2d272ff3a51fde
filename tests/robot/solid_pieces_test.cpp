// Meshes as simple solids: all of the mesh is in one of them, and not much else.
#include "robot/urdf/solid_pieces.h"

#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "sampled_distance.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::robot {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

std::vector<Shape> piecesOf(const TriangleMesh& mesh, int maxPieces = 16) {
  return solidPieces(mesh, maxPieces, base::RunContext{});
}

bool held(const std::vector<Shape>& pieces, const Vector3d& p) {
  return std::ranges::any_of(
      pieces, [&](const Shape& piece) { return test::signedDistance(p, piece) < 1e-6; });
}

// Share of a mesh's bounding box that the solids fill, from points.
double volumeOf(const std::vector<Shape>& pieces, const Eigen::AlignedBox3d& bounds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr int kPoints = 20000;
  int in = 0;
  for (int k = 0; k < kPoints; ++k)
    in += held(pieces, bounds.min() + bounds.sizes().cwiseProduct(
                                          Vector3d(share(random), share(random), share(random))));
  return bounds.volume() * in / kPoints;
}

// Points on the surface and, of a closed mesh, in it.
void expectHeld(const TriangleMesh& mesh, const std::vector<Shape>& pieces) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int missed = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 20; ++k) {
      double u = share(random), v = share(random);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      missed += !held(pieces, mesh.corner(t, 0) + u * (mesh.corner(t, 1) - mesh.corner(t, 0)) +
                                  v * (mesh.corner(t, 2) - mesh.corner(t, 0)));
    }
  const geometry::MeshQuery query(mesh);
  const Eigen::AlignedBox3d bounds = geometry::bounds(mesh);
  for (int k = 0; k < 2000; ++k) {
    const Vector3d p = bounds.min() + bounds.sizes().cwiseProduct(
                                          Vector3d(share(random), share(random), share(random)));
    missed += query.inside(p) && !held(pieces, p);
  }
  EXPECT_EQ(missed, 0);
}

TriangleMesh turned(TriangleMesh mesh) {
  const Eigen::AngleAxisd rotation(0.6, Vector3d(1, -2, 0.5).normalized());
  for (Vector3d& p : mesh.vertices)
    p = rotation * p + Vector3d(100, 20, -40);
  return mesh;
}

// A plate on four legs, which no single cut makes smaller. One component, as the legs go into the
// plate's own corners, or five.
TriangleMesh table() {
  TriangleMesh mesh = test::box({0, 0, 700}, {1200, 800, 740});
  for (const double x : {0.0, 1140.0})
    for (const double y : {0.0, 740.0})
      test::append(mesh, test::box({x, y, 0}, {x + 60, y + 60, 700}));
  return mesh;
}

// A room's corner: an L of two walls as one closed mesh, which no one solid fits.
TriangleMesh angleIron() {
  TriangleMesh mesh;
  const std::vector<Eigen::Vector2d> outline{{0, 0},   {300, 0},  {300, 20},
                                             {20, 20}, {20, 300}, {0, 300}};
  for (const double z : {0.0, 500.0})
    for (const Eigen::Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  const std::vector<std::array<int, 3>> floor{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (const std::array<int, 3>& t : floor) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

TEST(SolidPieces, SimpleSolidsAreThemselves) {
  const TriangleMesh box = test::box({-20, 0, 5}, {30, 10, 25});
  for (const TriangleMesh& mesh : {box, turned(box)}) {
    const auto pieces = piecesOf(mesh);
    ASSERT_EQ(pieces.size(), 1u);
    expectHeld(mesh, pieces);
    ASSERT_TRUE(std::holds_alternative<Box>(pieces.front()));
    EXPECT_NEAR(8.0 * std::get<Box>(pieces.front()).half.prod(), 50 * 10 * 20, 1.0);
  }
  const TriangleMesh ball = test::sphere({5, 0, 0}, 50.0);
  const auto ofBall = piecesOf(ball);
  ASSERT_EQ(ofBall.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<Capsule>(ofBall.front()));
  expectHeld(ball, ofBall);
}

TEST(SolidPieces, UnderATableIsRoom) {
  for (const TriangleMesh& mesh : {table(), turned(table())}) {
    const auto pieces = piecesOf(mesh);
    EXPECT_EQ(pieces.size(), 5u);
    expectHeld(mesh, pieces);
    EXPECT_LT(volumeOf(pieces, geometry::bounds(mesh)), 1.15 * geometry::volume(mesh));
  }
  EXPECT_FALSE(held(piecesOf(table()), {600, 400, 300}));
}

TEST(SolidPieces, OneMeshOfSeveralParts) {
  for (const TriangleMesh& mesh : {angleIron(), turned(angleIron())}) {
    const auto pieces = piecesOf(mesh);
    EXPECT_GT(pieces.size(), 1u);
    EXPECT_LE(pieces.size(), 16u);
    expectHeld(mesh, pieces);
  }
  EXPECT_FALSE(held(piecesOf(angleIron()), {150, 150, 250}));
}

TEST(SolidPieces, NoMorePiecesThanTheLimit) {
  TriangleMesh balls;
  for (int i = 0; i < 10; ++i)
    test::append(balls, test::sphere({100.0 * i, 0, 0}, 10.0, 6));
  for (const TriangleMesh& mesh : {table(), angleIron(), balls})
    for (const int maxPieces : {1, 3, 6}) {
      const auto pieces = piecesOf(mesh, maxPieces);
      EXPECT_LE(static_cast<int>(pieces.size()), maxPieces);
      expectHeld(mesh, pieces);
    }
}

TEST(SolidPieces, AnOpenSheetIsThick) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {100, 0, 0}, {100, 50, 0}, {0, 50, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto pieces = piecesOf(sheet);
  expectHeld(sheet, pieces);
  EXPECT_TRUE(held(pieces, {50, 25, 0.4}));
  EXPECT_FALSE(held(pieces, {50, 25, 1.0}));
}

TEST(SolidPieces, ABlockIsFullInside) {
  // With a slab beside it that enters it: one component or two, cut into cubes where no single
  // solid fits, of which many are deep inside.
  TriangleMesh block = turned(test::box({0, 0, 0}, {100, 100, 100}));
  test::append(block, turned(test::box({50, 0, 0}, {200, 100, 20})));
  expectHeld(block, piecesOf(block));
}

} // namespace
} // namespace voluta::robot
