#include "curved/front_surface.h"

#include "base/error.h"
#include "curved/convex_hull.h"
#include "curved/voxel_graph.h"
#include "geometry/convex_polygon.h"

#include <cmath>

namespace voluta::curved {

namespace {

using Corners = std::vector<Eigen::Vector2d>;

// Returns the row ends (x, y) of one slice that the slice's planar hull needs.
Corners sliceCorners(const Decomposition& d, std::int32_t rank, int k) {
  const Eigen::Vector3i& size = d.grid.size;
  Corners ends;
  for (int j = 0; j < size.y(); ++j) {
    const std::int32_t* row = d.rank.data() + d.grid.index(0, j, k);
    const auto isPrinted = [&](int i) { return row[i] > 0 && row[i] <= rank; };
    int low = 0, high = size.x() - 1;
    while (low <= high && !isPrinted(low))
      ++low;
    if (low > high)
      continue;
    while (!isPrinted(high))
      --high;
    ends.emplace_back(low, j);
    if (high > low)
      ends.emplace_back(high, j);
  }
  return ends.size() < 3 ? ends : geometry::convexPolygon(std::move(ends));
}

} // namespace

geometry::TriangleMesh frontSurface(const Decomposition& d, std::int32_t rank) {
  base::require(d.rank.size() == d.grid.cellCount(), "frontSurface: one rank a cell");
  base::require(d.platform.size() >= 3, "frontSurface: a platform of three corners or more");
  const voxel::VoxelGrid& grid = d.grid;
  std::vector<LatticePoint> points;
  for (const Eigen::Vector2d& corner : d.platform) {
    const Eigen::Vector2d at = (corner - grid.origin.head<2>()) / grid.pitch * kLatticePerCell;
    points.emplace_back(std::round(at.x()), std::round(at.y()), 0.0);
  }
  const double plate = std::round(-grid.origin.z() / grid.pitch);
  for (int k = 0; k < grid.size.z(); ++k)
    for (const Eigen::Vector2d& cell : sliceCorners(d, rank, k))
      points.emplace_back(kLatticePerCell * cell.x() + 8.0, kLatticePerCell * cell.y() + 8.0,
                          kLatticePerCell * (k - plate) + 8.0);

  geometry::TriangleMesh surface;
  if (points.size() == d.platform.size())
    return surface;
  std::vector<int> vertexOf(points.size(), -1);
  const Eigen::Vector3d corner(grid.origin.x(), grid.origin.y(), 0.0);
  for (const HullFacet& facet : convexHull(points)) {
    std::array<int, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto point = static_cast<std::size_t>(facet.corner[c]);
      if (vertexOf[point] < 0) {
        vertexOf[point] = static_cast<int>(surface.vertices.size());
        surface.vertices.push_back(corner + grid.pitch / kLatticePerCell * points[point]);
      }
      triangle[c] = vertexOf[point];
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

} // namespace voluta::curved
