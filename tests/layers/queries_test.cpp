// Where segments meet a part and the layers before.
#include "base/run_context.h"
#include "helpers/flat_square.h"
#include "helpers/shapes.h"
#include "layers/layer_checks.h"
#include "layers/part_boundary.h"
#include "layers/stack_query.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::layers {
namespace {

using Eigen::Vector3d;

// Two blocks with a gap between them, along x.
geometry::TriangleMesh twoBlocks() {
  geometry::TriangleMesh part = test::box({0, 0, 0}, {4, 10, 10});
  test::append(part, test::box({6, 0, 0}, {12, 10, 10}));
  return part;
}

TEST(PartBoundary, EnteringAndLeavingAlternateThroughTwoBlocks) {
  const geometry::TriangleMesh part = twoBlocks();
  const PartBoundary boundary(part, 1.0, base::RunContext());
  std::vector<PartBoundary::Crossing> found;
  const Vector3d a(-2, 5, 5), b(14, 5.1, 5.2);
  boundary.crossings(a, b, 0.01, found);
  ASSERT_EQ(found.size(), 4u);
  const double at[] = {0.0, 4.0, 6.0, 12.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].entering, i % 2 == 0);
    EXPECT_NEAR(found[i].t, (at[i] + 2.0) / 16.0, 1e-9);
  }
  // From within the first: out, in, out.
  boundary.crossings({1, 5, 5}, b, 0.01, found);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_FALSE(found[0].entering);
  EXPECT_TRUE(found[1].entering);
  boundary.crossings({-2, 5, 5}, {7, 5.1, 5.2}, 0.01, found);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[2].entering);
}

TEST(PartBoundary, AGrazeIsLeftOut) {
  const geometry::TriangleMesh part = twoBlocks();
  const PartBoundary boundary(part, 1.0, base::RunContext());
  std::vector<PartBoundary::Crossing> found;
  boundary.crossings({-2, 5, 5}, {5, 5.1, 5.2}, 4.5, found);
  EXPECT_TRUE(found.empty()) << "the first block is 4 mm wide";
}

TEST(PartBoundary, LinesOutsideThePartDoNotCross) {
  const geometry::TriangleMesh part = twoBlocks();
  const PartBoundary boundary(part, 1.0, base::RunContext());
  EXPECT_TRUE(boundary.mayCross({-2, 5, 5}, {14, 5, 5}));
  for (int axis = 0; axis < 3; ++axis)
    for (const double off : {-30.0, 40.0}) {
      Vector3d a(-2, 5, 5), b(14, 5, 5);
      a[axis] = b[axis] = off;
      EXPECT_FALSE(boundary.mayCross(a, b)) << axis;
    }
  EXPECT_FALSE(boundary.mayCross({7.8, 3, 3}, {10.2, 7, 7})) << "well inside";
}

// Of the outline of a patch in a block one long side is on a face, or none.
TEST(BoundaryChecks, FindTheShareOfTheOutlineOnTheSurface) {
  LayerStack stack;
  Patch patch;
  patch.surface.vertices = {{2, 0, 5}, {8, 0, 5}, {8, 1.5, 5}, {2, 1.5, 5}};
  patch.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  stack.patches.push_back(patch);
  const geometry::TriangleMesh part = test::box({0, 0, 0}, {10, 10, 10});
  const geometry::MeshQuery query(part);
  for (const double shiftMm : {0.0, 0.5}) {
    for (Vector3d& p : stack.patches[0].surface.vertices)
      p.y() += shiftMm;
    const BoundaryCheck check = checkBoundaries(stack, query, 1e-3, {}).front();
    EXPECT_TRUE(check.simple);
    EXPECT_NEAR(check.onSurface, shiftMm == 0.0 ? 6.0 / 15.0 : 0.0, 1e-12);
    EXPECT_NEAR(check.farthestMm, 1.5 + shiftMm, 1e-9);
  }
}

// Lines that cross a facet are always found, whatever their position.
TEST(PartBoundary, CrossingsAreNeverMissed) {
  const geometry::TriangleMesh part = twoBlocks();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-3, 14);
  int crossing = 0, passing = 0;
  for (const double cellMm : {0.7, 2.5}) {
    const PartBoundary boundary(part, cellMm, base::RunContext());
    std::vector<PartBoundary::Crossing> found;
    for (int round = 0; round < 2000; ++round) {
      const Vector3d a(u(random), u(random), u(random));
      Vector3d b(u(random), u(random), u(random));
      b = a + (round % 2 ? 0.2 : 1.0) * (b - a);
      boundary.crossings(a, b, 0.0, found);
      // By how often it is in either block along the way.
      const auto inside = [](const Vector3d& p) {
        return ((p.x() > 0 && p.x() < 4) || (p.x() > 6 && p.x() < 12)) && p.y() > 0 && p.y() < 10 &&
               p.z() > 0 && p.z() < 10;
      };
      for (std::size_t k = 0; k < found.size(); ++k) {
        const double before = k == 0 ? 0.0 : found[k - 1].t;
        EXPECT_EQ(inside(a + 0.5 * (before + found[k].t) * (b - a)), !found[k].entering);
      }
      const double last = found.empty() ? 0.0 : found.back().t;
      EXPECT_EQ(inside(a + 0.5 * (last + 1.0) * (b - a)),
                found.empty() ? inside(a) : found.back().entering);
      if (!found.empty()) {
        EXPECT_TRUE(boundary.mayCross(a, b));
      }
      crossing += found.empty() ? 0 : 1;
      passing += boundary.mayCross(a, b) ? 0 : 1;
    }
  }
  EXPECT_GT(crossing, 500);
  EXPECT_GT(passing, 200);
}

// Flat triangles far enough apart that the nearest point follows from planes and edges by hand.
TEST(StackQuery, ClosestIsOverAllPatchesInTheQuery) {
  std::vector<Patch> patches;
  for (int k = 0; k < 4; ++k) {
    Patch patch;
    const double x = 3.0 * k, z = 0.5 * k;
    patch.surface.vertices = {{x, 0, z}, {x + 2, 0, z}, {x, 2, z}};
    patch.surface.triangles = {{0, 1, 2}};
    patches.push_back(std::move(patch));
  }
  const StackQuery query(patches, {Eigen::AlignedBox3d(Vector3d(0, 0, 0), Vector3d(9, 3, 3))}, 1.0,
                         base::RunContext());
  const StackQuery::Place over = query.closest({0, 1, 2, 3}, {3.5, 0.5, 1.4}, 2.0);
  EXPECT_EQ(over.patch, 1);
  EXPECT_EQ(over.triangle, 0);
  EXPECT_NEAR(over.distance, 0.9, 1e-12);
  EXPECT_LT((over.point - Vector3d(3.5, 0.5, 0.5)).norm(), 1e-12);
  EXPECT_EQ(query.closest({0, 1, 2, 3}, {3.5, 0.5, 1.4}, 0.8).patch, -1) << "out of reach";
  EXPECT_EQ(query.closest({0, 2, 3}, {3.5, 0.5, 1.4}, 0.8).patch, -1) << "not asked for";
  // Between two: nearer to the corner of the second, for both orders.
  for (const std::vector<int>& asked : {std::vector<int>{0, 1}, {1, 0}}) {
    const StackQuery::Place beside = query.closest(asked, {2.7, 0.0, 0.5}, 2.0);
    EXPECT_EQ(beside.patch, 1);
    EXPECT_NEAR(beside.distance, 0.3, 1e-12);
  }
  const auto box = [](double from, double to) {
    return Eigen::AlignedBox3d(Vector3d(from, 0, 0), Vector3d(to, 1, 9));
  };
  EXPECT_EQ(query.near(box(2.5, 7.0), 0, 4), (std::vector<int>{1, 2}));
  EXPECT_EQ(query.near(box(2.5, 7.0), 2, 4), (std::vector<int>{2}));
  EXPECT_EQ(query.near(box(-5.0, 20.0), 0, 3), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(query.near(box(2.2, 2.8), 0, 4).empty());
  // Only patches near the boxes it is made for are known.
  const StackQuery some(patches, {box(0.0, 2.5)}, 1.0, base::RunContext());
  EXPECT_EQ(some.near(box(-5.0, 20.0), 0, 4), (std::vector<int>{0, 1}));
}

TEST(StackQuery, HitsComeInOrderFromTheStart) {
  std::vector<Patch> patches;
  for (const double z : {0.4, 1.2, 2.0, 2.8}) {
    Patch patch;
    patch.surface = test::flatSquare(5.0, 1.0, z).surface;
    patches.push_back(std::move(patch));
  }
  const StackQuery query(patches, {Eigen::AlignedBox3d(Vector3d(-5, -5, 0), Vector3d(15, 15, 4))},
                         1.0, base::RunContext());
  std::vector<StackQuery::Place> found;
  const Vector3d inside = (patches[0].surface.corner(0, 0) + patches[0].surface.corner(0, 1) +
                           patches[0].surface.corner(0, 2)) /
                          3.0;
  query.hits({0, 1, 2, 3}, {inside.x(), inside.y(), 4.0}, {inside.x(), inside.y(), 0.0}, found);
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].patch, 3 - static_cast<int>(i));
    EXPECT_NEAR(found[i].distance, 1.2 + 0.8 * static_cast<double>(i), 1e-9);
  }
}

} // namespace
} // namespace voluta::layers
