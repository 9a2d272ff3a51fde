#include "milling/height_map.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Points on an edge belong to both of its triangles, so that rounding leaves no gap between them.
constexpr double kOnEdge = 1e-9;
// Where the material over a cell is summed, so that no edge of a drawing is crossed there [mm].
const Vector2d kBeside(1.7e-5, 2.9e-5);

struct CellRange {
  int first = 0, last = 0;
};

// Returns the cells of a row or column, within [begin, end), whose middles are between two places.
CellRange cellsBetween(double low, double high, double pitchMm, int begin, int end) {
  const auto bound = [&](double cell) {
    return static_cast<int>(std::clamp(cell, begin - 1.0, 1.0 * end));
  };
  return {std::max(begin, bound(std::ceil(low / pitchMm - 0.5 - kOnEdge))),
          std::min(end - 1, bound(std::floor(high / pitchMm - 0.5 + kOnEdge)))};
}

// Raises the map's cells of rows [begin, end) whose middles are within the triangle's projection.
void raise(HeightMap& map, const std::array<Vector3d, 3>& corner, int begin, int end) {
  const CellGrid& grid = map.grid;
  const auto range = [&](int axis, int from, int to) {
    const auto [low, high] = std::minmax({corner[0][axis], corner[1][axis], corner[2][axis]});
    return cellsBetween(low - grid.low[axis], high - grid.low[axis], grid.pitchMm, from, to);
  };
  const CellRange rows = range(1, begin, end), columns = range(0, 0, grid.countX);
  const Vector2d a = corner[0].head<2>(), u = corner[1].head<2>() - a, v = corner[2].head<2>() - a;
  const double twice = u.x() * v.y() - u.y() * v.x();
  if (twice == 0.0)
    return;                                     // vertical: its neighbours have its edges
  const double side = twice > 0.0 ? 1.0 : -1.0; // faces up
  for (int j = rows.first; j <= rows.last; ++j)
    for (int i = columns.first; i <= columns.last; ++i) {
      const Vector2d d = grid.middle(i, j) - a;
      const Vector2d beside = d + kBeside;
      const double besideU = (beside.x() * v.y() - beside.y() * v.x()) / twice,
                   besideV = (u.x() * beside.y() - u.y() * beside.x()) / twice;
      if (besideU >= 0.0 && besideV >= 0.0 && besideU + besideV < 1.0) {
        const double z = corner[0].z() + besideU * (corner[1].z() - corner[0].z()) +
                         besideV * (corner[2].z() - corner[0].z());
        map.solidMm[grid.index(i, j)] += side * z;
        map.solidMomentMm2[grid.index(i, j)] += 0.5 * side * z * z;
      }
      const double alongU = (d.x() * v.y() - d.y() * v.x()) / twice,
                   alongV = (u.x() * d.y() - u.y() * d.x()) / twice;
      if (alongU < -kOnEdge || alongV < -kOnEdge || alongU + alongV > 1.0 + kOnEdge)
        continue;
      double& top = map.top[grid.index(i, j)];
      top = std::max(top, corner[0].z() + alongU * (corner[1].z() - corner[0].z()) +
                              alongV * (corner[2].z() - corner[0].z()));
    }
}

} // namespace

CellGrid gridOver(const Vector2d& low, const Vector2d& high, double pitchMm) {
  const Vector2d cells = ((high - low) / pitchMm).array().ceil();
  return {low, pitchMm, std::max(1, static_cast<int>(cells.x())),
          std::max(1, static_cast<int>(cells.y()))};
}

HeightMap heightMap(const geometry::TriangleMesh& part, const CellGrid& grid,
                    const base::RunContext& ctx) {
  constexpr std::size_t kRows = 64;
  HeightMap map{grid, std::vector<double>(grid.size(), HeightMap::kNone),
                std::vector<double>(grid.size(), 0.0), std::vector<double>(grid.size(), 0.0)};
  const auto at = [&](int vertex) { return part.vertices[static_cast<std::size_t>(vertex)]; };
  base::parallelChunks(
      ctx, static_cast<std::size_t>(grid.countY), kRows, [&](std::size_t begin, std::size_t end) {
        for (const auto& [a, b, c] : part.triangles)
          raise(map, {at(a), at(b), at(c)}, static_cast<int>(begin), static_cast<int>(end));
      });
  return map;
}

} // namespace voluta::milling
