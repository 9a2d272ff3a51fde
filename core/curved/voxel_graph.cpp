#include "curved/voxel_graph.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace voluta::curved {

const std::array<Eigen::Vector3i, kNeighbours> kNeighbourStep = [] {
  std::array<Eigen::Vector3i, kNeighbours> steps;
  std::size_t n = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1})
      steps[n++] = sign * Eigen::Vector3i::Unit(axis);
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b)
      for (const int sa : {-1, 1})
        for (const int sb : {-1, 1})
          steps[n++] = sa * Eigen::Vector3i::Unit(a) + sb * Eigen::Vector3i::Unit(b);
  return steps;
}();

const std::array<float, kNeighbours> kNeighbourDistance = [] {
  std::array<float, kNeighbours> d;
  for (std::size_t n = 0; n < kNeighbours; ++n)
    d[n] = n < 6 ? 1.0f : std::sqrt(2.0f);
  return d;
}();

VoxelGraph voxelGraph(const voxel::VoxelGrid& grid, const std::vector<std::uint8_t>& use,
                      int plateLayer, const std::vector<Eigen::Vector2d>& platform) {
  base::require(use.size() == grid.cellCount(), "voxelGraph: one entry a cell");
  base::require(platform.size() >= 3, "voxelGraph: a platform has three corners or more");
  VoxelGraph graph;
  graph.grid = grid;
  graph.plateLayer = plateLayer;
  graph.voxelAt.assign(use.size(), -1);
  for (int k = std::max(0, plateLayer); k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        if (const std::size_t at = grid.index(i, j, k); use[at]) {
          graph.voxelAt[at] = static_cast<std::int32_t>(graph.cell.size());
          graph.cell.push_back({static_cast<std::int16_t>(i), static_cast<std::int16_t>(j),
                                static_cast<std::int16_t>(k)});
        }

  graph.neighbour.resize(graph.size());
  graph.onPlatform.assign(graph.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto [i, j, k] = graph.cell[v];
    for (std::size_t n = 0; n < kNeighbours; ++n) {
      const Eigen::Vector3i& s = kNeighbourStep[n];
      graph.neighbour[v][n] = grid.contains(i + s.x(), j + s.y(), k + s.z())
                                  ? graph.voxelAt[grid.index(i + s.x(), j + s.y(), k + s.z())]
                                  : -1;
    }
    if (k != plateLayer)
      continue;
    const Eigen::Vector2d p = grid.centre(i, j, k).head<2>();
    bool over = true;
    for (std::size_t c = 0; c < platform.size() && over; ++c) {
      const Eigen::Vector2d &a = platform[c], &b = platform[(c + 1) % platform.size()];
      const Eigen::Vector2d side = b - a;
      over = side.x() * (p.y() - a.y()) - side.y() * (p.x() - a.x()) >=
             -1e-6 * grid.pitch * side.norm();
    }
    graph.onPlatform[v] = over ? 1 : 0;
  }

  for (const Eigen::Vector2d& corner : platform) {
    const Eigen::Vector2d at = (corner - grid.origin.head<2>()) / grid.pitch * kLatticePerCell;
    graph.platform.emplace_back(std::round(at.x()), std::round(at.y()), 0.0);
  }
  const bool flat = graph.size() > 0 &&
                    std::all_of(graph.cell.begin(), graph.cell.end(),
                                [&](const auto& cell) { return cell[1] == graph.cell[0][1]; });
  if (flat) {
    const auto [low, high] = std::minmax_element(
        graph.platform.begin(), graph.platform.end(),
        [](const LatticePoint& l, const LatticePoint& r) { return l.x() < r.x(); });
    const double middle = kLatticePerCell * graph.cell[0][1] + 8.0,
                 wide = kLatticePerCell * kFlatPlatformCells;
    graph.platform = {{low->x(), middle - wide, 0.0},
                      {high->x(), middle - wide, 0.0},
                      {high->x(), middle + wide, 0.0},
                      {low->x(), middle + wide, 0.0}};
  }
  return graph;
}

} // namespace voluta::curved
