// The volume that no bead reaches, against closed forms.
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/append_mesh.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "replay/bead_coverage.h"
#include "replay/thin_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace voluta::replay {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const base::RunContext kOne;
constexpr double kBead = 0.4, kRadius = 0.5 * kBead;

// A prism over a convex polygon, counter-clockwise.
geometry::TriangleMesh prism(const std::vector<Vector2d>& outline, double low, double high) {
  geometry::TriangleMesh mesh;
  const int n = static_cast<int>(outline.size());
  for (const double z : {low, high})
    for (const Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (i > 0 && i + 1 < n) {
      mesh.triangles.push_back({0, i + 1, i});
      mesh.triangles.push_back({n, n + i, n + i + 1});
    }
  }
  return mesh;
}

// The area that an opening takes from a corner.
double cornerMm2(double angle) {
  return kRadius * kRadius * (1.0 / std::tan(0.5 * angle) - 0.5 * (base::kPi - angle));
}

struct Thin {
  double mm3 = 0.0, partMm3 = 0.0;
  Coverage coverage; // without any beads
};
Thin thinOf(const geometry::TriangleMesh& part, double pitch = 0.1) {
  Vector3d low = part.vertices.front(), high = low;
  for (const Vector3d& v : part.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  // So that neither faces nor walls lie between cells.
  const voxel::VoxelGrid grid = gridOver(low - Vector3d(0.837, 0.873, 0.769),
                                         high + Vector3d::Constant(0.8), pitch, 48'000'000);
  const geometry::MeshQuery query(part);
  const PartCells cells = partCells(part, query, grid, kOne);
  const ThinCells thin = thinCells(part, cells, grid, kBead, kOne);
  BeadGrid beads;
  beads.grid = grid;
  beads.fill = base::ZeroedArray<float>(grid.cellCount());
  return {thin.volumeMm3, cells.volumeMm3,
          measureCoverage(beads, cells, query, {.outsideMm = 0.1, .notchMm = 0.1}, kOne, {}, thin)};
}

} // namespace

TEST(ThinCells, CornersOfPrismsByTheirClosedForm) {
  for (const double degrees : {20.0, 60.0, 90.0, 120.0}) {
    const double angle = base::degreesToRadians(degrees), half = 0.5 * angle;
    // An isosceles triangle with sides of 12 mm
    const std::vector<Vector2d> outline{{0, 0},
                                        {12.0 * std::cos(half), -12.0 * std::sin(half)},
                                        {12.0 * std::cos(half), 12.0 * std::sin(half)}};
    const double height = 3.0, expected = height * (cornerMm2(angle) +
                                                    2.0 * cornerMm2(0.5 * (base::kPi - angle)));
    const Thin thin = thinOf(prism(outline, 0.0, height), 0.04);
    EXPECT_NEAR(thin.mm3, expected, 0.06 * expected) << degrees;
  }
}

// Whatever the height: a part of one layer has the same share as a higher one.
TEST(ThinCells, ALayerHasTheShareOfItsSection) {
  const std::vector<Vector2d> outline{{0, 0}, {10, 0}, {5, 8}};
  const Thin high = thinOf(prism(outline, 0.0, 6.0)), low = thinOf(prism(outline, 0.0, 0.2));
  EXPECT_NEAR(low.mm3 / low.partMm3, high.mm3 / high.partMm3, 0.1 * high.mm3 / high.partMm3);
  const Thin plate = thinOf(test::box({0, 0, 0}, {10, 10, 0.2}));
  EXPECT_LT(plate.mm3, 0.0025 * plate.partMm3) << "its four corners";
}

// Upright, a wedge is thin from its edge to where a bead fits between its sides.
TEST(ThinCells, AWedgesEdge) {
  const double angle = base::degreesToRadians(5.0);
  const std::vector<Vector2d> outline{
      {0, 0}, {20, -20 * std::tan(0.5 * angle)}, {20, 20 * std::tan(0.5 * angle)}};
  const Thin thin = thinOf(prism(outline, 0.0, 4.0), 0.05);
  const double expected = 4.0 * (cornerMm2(angle) + 2.0 * cornerMm2(0.5 * (base::kPi - angle)));
  EXPECT_NEAR(thin.mm3, expected, 0.05 * expected);
  // Lying, its layers are long, and only their own corners are lost.
  geometry::TriangleMesh wedge = prism({{0, 0}, {10, 0}, {10, 2}}, 0.0, 6.0);
  for (Vector3d& v : wedge.vertices)
    v = Vector3d(v.x(), -v.z(), v.y());
  const Thin lying = thinOf(wedge);
  EXPECT_LT(lying.mm3, 0.0025 * lying.partMm3);
}

// Bars narrower than a bead are thin but for their crossing, others are not; walls exactly as wide
// as a bead are none.
TEST(ThinCells, ACrossOfThinBars) {
  for (const auto& [width, isThin] : {std::pair{0.3, true}, std::pair{0.4, false}}) {
    const double w = 0.5 * width;
    geometry::TriangleMesh cross = test::box({-8, -w, 0}, {8, w, 2});
    geometry::appendMesh(cross, test::box({-w, -8, 0}, {w, 8, 2}));
    const Thin thin = thinOf(cross, 0.05);
    const double all = 2.0 * (2 * 16 * width - width * width);
    if (isThin)
      EXPECT_NEAR(thin.mm3, all, 0.06 * all);
    else
      EXPECT_LT(thin.mm3, 0.03 * all) << "the corners of its ends";
  }
}

TEST(ThinCells, ARoundBodyHasNone) {
  std::vector<Vector2d> outline;
  for (int k = 0; k < 90; ++k)
    outline.emplace_back(5.0 * std::cos(base::kPi * k / 45), 5.0 * std::sin(base::kPi * k / 45));
  const Thin thin = thinOf(prism(outline, 0.0, 3.0));
  EXPECT_LT(thin.mm3, 1e-4 * thin.partMm3);
}

// Open volume is either thin or uncovered, and its places are counted.
TEST(ThinCells, AreNoGaps) {
  const std::vector<Vector2d> outline{{0, 0}, {14, 0}, {7, 6.5}};
  const geometry::TriangleMesh part = prism(outline, 0.0, 6.0);
  const Thin bare = thinOf(part);
  EXPECT_NEAR(bare.coverage.coveredFraction, 0.0, 1e-9);
  EXPECT_NEAR(bare.coverage.thinMm3, bare.mm3, 1e-6 + 1e-6 * bare.mm3);
  EXPECT_EQ(bare.coverage.thinPlaces, 3u) << "its corners";
  const Vector2d worst = bare.coverage.worstThin.head<2>();
  EXPECT_LT(std::min(worst.norm(), (worst - Vector2d(14, 0)).norm()), 2.0);

  // Filled up but for the thin places
  const voxel::VoxelGrid grid = gridOver({-1.03, -1.07, -0.97}, {15, 8, 7}, 0.1, 48'000'000);
  const geometry::MeshQuery query(part);
  const PartCells cells = partCells(part, query, grid, kOne);
  const ThinCells thin = thinCells(part, cells, grid, kBead, kOne);
  BeadGrid beads;
  beads.grid = grid;
  beads.fill = base::ZeroedArray<float>(grid.cellCount());
  for (std::size_t c = 0; c < beads.fill.size(); ++c)
    beads.fill[c] = static_cast<float>(cells.share[c]) / 255.0f;
  for (const ThinCells::Cell& cell : thin.cells)
    beads.fill[cell.index] = static_cast<float>(cells.share[cell.index] - cell.share) / 255.0f;
  const SurfaceBands bands{.outsideMm = 0.1, .notchMm = 0.1};
  const Coverage left = measureCoverage(beads, cells, query, bands, kOne, {}, thin);
  EXPECT_NEAR(left.coveredFraction, 1.0, 1e-6);
  EXPECT_NEAR(left.thinMm3, thin.volumeMm3, 1e-6);
  EXPECT_NEAR(left.worstGapMm3, 0.0, 1e-6);
  const Coverage plain = measureCoverage(beads, cells, query, bands, kOne);
  EXPECT_NEAR(1.0 - plain.coveredFraction, thin.volumeMm3 / cells.volumeMm3, 1e-6)
      << "the same volume, as a gap";
  EXPECT_EQ(plain.thinMm3, 0.0);
}

TEST(ThinCells, OnlyOfPlansWithLevelLayers) {
  plan::ToolPlan plan;
  EXPECT_FALSE(hasLevelLayers(plan));
  for (int i = 0; i < 40; ++i) {
    plan.position.emplace_back(i, 0, 0.2);
    plan.direction.emplace_back(Vector3d::UnitZ());
  }
  plan.paths.push_back({.first = 0, .count = 40});
  EXPECT_TRUE(hasLevelLayers(plan));
  plan.direction[7] = Vector3d(0.3, 0, 1).normalized();
  EXPECT_TRUE(hasLevelLayers(plan)) << "a bead pressed against its neighbour";
  for (int i = 0; i < 10; ++i)
    plan.direction[static_cast<std::size_t>(i)] = Vector3d(0.3, 0, 1).normalized();
  EXPECT_FALSE(hasLevelLayers(plan));
}

} // namespace voluta::replay
