// Where segments meet a part and the layers before.
#include "base/run_context.h"
#include "helpers/flat_square.h"
#include "helpers/shapes.h"
#include "layers/layer_checks.h"
#include "layers/part_boundary.h"
#include "layers/stack_query.h"

#include <gtest/gtest.h>

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

TEST(PartBoundary, WhatPassesByMayNotCross) {
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

// Of the outline of a patch in a block one long side lies on a face, or none.
TEST(BoundaryChecks, TellTheShareOfTheOutlineOnTheSurface) {
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
