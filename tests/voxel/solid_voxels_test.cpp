#include "voxel/solid_voxels.h"

#include "base/error.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace voluta::voxel {
namespace {

using geometry::TriangleMesh;
const base::RunContext kQuiet;

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int shift = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

TriangleMesh inverted(TriangleMesh m) {
  for (auto& t : m.triangles)
    std::swap(t[1], t[2]);
  return m;
}

bool solidAt(const SolidVoxels& v, const Eigen::Vector3d& p) {
  const Eigen::Vector3i c = v.grid.cellOf(p);
  return v.grid.contains(c.x(), c.y(), c.z()) && v.solid[v.grid.index(c.x(), c.y(), c.z())];
}

TEST(SolidVoxels, BoxOnWholeCellsGetsNoLayerForItsFaces) {
  const SolidVoxels v = solidVoxels(test::box({0, 0, 0}, {8, 4, 2}), 0.5, kQuiet);
  EXPECT_EQ(v.count, 16u * 8u * 4u);
  EXPECT_EQ(v.plateLayer(), 1);
  EXPECT_DOUBLE_EQ(v.grid.origin.z(), -0.5);
}

TEST(SolidVoxels, BoxBetweenCellsIsCovered) {
  const SolidVoxels v = solidVoxels(test::box({0, 0, 0}, {8.1, 4.1, 2.1}), 0.5, kQuiet);
  EXPECT_EQ(v.count, 17u * 9u * 5u);
}

TEST(SolidVoxels, BaseJustOffThePlateIsStillOnIt) {
  for (const double lift : {-1e-5, 1e-5}) {
    const SolidVoxels v = solidVoxels(test::box({0, 0, lift}, {5, 5, 5}), 0.5, kQuiet);
    EXPECT_EQ(v.count, 1000u) << lift;
    EXPECT_EQ(v.plateLayer(), 1);
  }
}

TEST(SolidVoxels, OutermostCellsAreEmpty) {
  const SolidVoxels v = solidVoxels(test::sphere({3, 4, 7}, 6.3), 0.7, kQuiet);
  for (std::size_t c = 0; c < v.solid.size(); ++c) {
    const Eigen::Vector3i cell = v.grid.cell(c);
    if ((cell.array() == 0).any() || (cell.array() == v.grid.size.array() - 1).any()) {
      EXPECT_EQ(v.solid[c], 0);
    }
  }
}

TEST(SolidVoxels, PlateIsABoundaryOfCellsForAnyHeightOfThePart) {
  for (const double z : {-3.3, 0.0, 2.15, 9.99}) {
    const SolidVoxels v = solidVoxels(test::sphere({0, 0, z}, 3.0), 0.4, kQuiet);
    const double cells = -v.grid.origin.z() / v.grid.pitch;
    EXPECT_NEAR(cells, std::round(cells), 1e-9) << z;
  }
}

// Random points in a sphere are in solid cells, points more than a cell's diagonal off are not.
TEST(SolidVoxels, ContainsTheSphereAndNoMoreThanItsCells) {
  const double r = 7.0, pitch = 0.6;
  const Eigen::Vector3d centre(1, 2, 7);
  const SolidVoxels v = solidVoxels(test::sphere(centre, r, 40), pitch, kQuiet);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1.3 * r, 1.3 * r);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p = centre + Eigen::Vector3d(in(random), in(random), in(random));
    const double d = (p - centre).norm();
    if (d < 0.995 * r) {
      EXPECT_TRUE(solidAt(v, p)) << p.transpose();
    } else if (d > r + std::sqrt(3.0) * pitch) {
      EXPECT_FALSE(solidAt(v, p)) << p.transpose();
    }
  }
}

TEST(SolidVoxels, CavityStaysEmpty) {
  const TriangleMesh hollow =
      joined(test::box({0, 0, 0}, {10, 10, 10}), inverted(test::box({2, 2, 2}, {8, 8, 8})));
  const SolidVoxels v = solidVoxels(hollow, 0.5, kQuiet);
  EXPECT_EQ(v.count, 8000u - 12u * 12u * 12u);
}

TEST(SolidVoxels, OverlappingShellsAddUp) {
  const TriangleMesh two = joined(test::box({0, 0, 0}, {6, 6, 6}), test::box({3, 3, 3}, {9, 9, 9}));
  const SolidVoxels v = solidVoxels(two, 0.5, kQuiet);
  EXPECT_EQ(v.count, 2u * 1728u - 216u);
}

TEST(SolidVoxels, OpenMeshIsFilledByWinding) {
  TriangleMesh open = test::sphere({0, 0, 5}, 5.0, 30);
  const SolidVoxels closed = solidVoxels(open, 0.5, kQuiet);
  open.triangles.erase(open.triangles.begin() + 900, open.triangles.begin() + 903);
  const SolidVoxels holed = solidVoxels(open, 0.5, kQuiet);
  EXPECT_NEAR(static_cast<double>(holed.count), static_cast<double>(closed.count), 4.0);
}

TEST(SolidVoxels, ColumnsThroughEdgesAndVerticesKeepTheirParity) {
  // Cell centres at whole multiples of the pitch: the diagonals of the box's faces and the poles of
  // the sphere are exactly on columns.
  const SolidVoxels v = solidVoxels(test::box({0, 0, 0}, {5, 5, 3}), 1.0, kQuiet);
  EXPECT_EQ(v.count, 75u);
  const SolidVoxels s = solidVoxels(test::sphere({0, 0, 4.5}, 4.5, 8), 1.0, kQuiet);
  for (std::size_t c = 0; c < s.solid.size(); ++c) {
    const Eigen::Vector3i cell = s.grid.cell(c);
    const double d =
        (s.grid.centre(cell.x(), cell.y(), cell.z()) - Eigen::Vector3d(0, 0, 4.5)).norm();
    if (d < 3.8) {
      EXPECT_EQ(s.solid[c], 1);
    }
    if (d > 4.5 + 0.87) {
      EXPECT_EQ(s.solid[c], 0);
    }
  }
}

TEST(SolidVoxels, SameForAnyNumberOfThreads) {
  const TriangleMesh mesh = test::sphere({0, 0, 6}, 6.0, 30);
  const SolidVoxels one = solidVoxels(mesh, 0.3, base::RunContext(base::CancelToken{}, 1));
  const SolidVoxels two = solidVoxels(mesh, 0.3, base::RunContext(base::CancelToken{}, 2));
  EXPECT_EQ(one.solid, two.solid);
}

TEST(SolidVoxels, RefusesEmptyMeshesAndBadPitches) {
  EXPECT_THROW(solidVoxels({}, 0.5, kQuiet), base::Error);
  const TriangleMesh mesh = test::sphere({0, 0, 6}, 6.0);
  EXPECT_THROW(solidVoxels(mesh, 0.0, kQuiet), base::Error);
  try {
    solidVoxels(mesh, 0.01, kQuiet, 1'000'000);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_FALSE(e.remedy().empty());
  }
}

TEST(SolidVoxels, StopsWhenCancelled) {
  base::CancelToken token;
  token.cancel();
  EXPECT_THROW(solidVoxels(test::sphere({0, 0, 6}, 6.0), 0.1, base::RunContext(token, 2)),
               base::Cancelled);
}

} // namespace
} // namespace voluta::voxel
