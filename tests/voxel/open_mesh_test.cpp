#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "voxel/column_parity.h"
#include "voxel/solid_voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace voluta::voxel {
namespace {

const base::RunContext kQuiet;

// A sphere with two holes apart, one of them of three triangles in a row, and a doubled facet.
geometry::TriangleMesh holed() {
  geometry::TriangleMesh mesh = test::sphere({0, 0, 5}, 5.0, 20);
  mesh.triangles.push_back(mesh.triangles[500]);
  mesh.triangles.erase(mesh.triangles.begin() + 900, mesh.triangles.begin() + 903);
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  return mesh;
}

TEST(OpenMesh, CapsCloseIt) {
  EXPECT_TRUE(capsOf(test::sphere({0, 0, 5}, 5.0)).empty());
  geometry::TriangleMesh mesh = holed();
  const geometry::TriangleMesh caps = capsOf(mesh);
  EXPECT_EQ(caps.triangles.size(), 5u + 3u + 3u);
  test::append(mesh, caps);
  EXPECT_TRUE(capsOf(mesh).empty());
}

// The two ways to the same number: caps taken off a whole one, and the mesh itself.
TEST(OpenMesh, FillsByTheMeshsOwnWindingNumber) {
  const geometry::TriangleMesh mesh = holed();
  const SolidVoxels grid = solidVoxels(mesh, 0.5, kQuiet);
  std::vector<std::uint8_t> filled(grid.grid.cellCount(), 0);
  fillOpen(mesh, capsOf(mesh), grid.grid, filled, kQuiet);
  const geometry::MeshQuery query(mesh);
  std::size_t inside = 0;
  for (std::size_t c = 0; c < filled.size(); ++c) {
    const Eigen::Vector3i at = grid.grid.cell(c);
    const double w = std::abs(query.windingNumber(grid.grid.centre(at.x(), at.y(), at.z())));
    if (std::abs(w - 0.5) < 0.02)
      continue; // within the expansion's error
    EXPECT_EQ(filled[c] != 0, w > 0.5) << at.transpose();
    inside += w > 0.5;
  }
  EXPECT_GT(inside, 3500u);
}

TEST(OpenMesh, InsideOutIsFilledToo) {
  geometry::TriangleMesh mesh = holed();
  const std::size_t count = solidVoxels(mesh, 0.5, kQuiet).count;
  for (auto& t : mesh.triangles)
    std::swap(t[1], t[2]);
  EXPECT_NEAR(static_cast<double>(solidVoxels(mesh, 0.5, kQuiet).count), static_cast<double>(count),
              2.0);
}

TEST(OpenMesh, SameForAnyNumberOfThreads) {
  const geometry::TriangleMesh mesh = holed();
  EXPECT_EQ(solidVoxels(mesh, 0.3, base::RunContext(base::CancelToken{}, 1)).solid,
            solidVoxels(mesh, 0.3, base::RunContext(base::CancelToken{}, 2)).solid);
}

} // namespace
} // namespace voluta::voxel
