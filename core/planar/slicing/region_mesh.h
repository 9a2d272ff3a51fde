// Triangulation of a planar region with triangles of about equal size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::planar {

struct RegionMesh {
  // The input points, then `splits`, then inner points.
  std::vector<Eigen::Vector2d> points;
  struct Split {
    int a, b; // indices of input points
    double t; // (1 - t) a + t b
  };
  std::vector<Split> splits;
  std::vector<std::array<int, 3>> triangles; // counter-clockwise
};

// Returns a constrained Delaunay triangulation of the region inside the `edges` (index pairs into
// `points`) by the rule of fillRegion: odd is inside. The boundary is unchanged: edges longer than
// edgeMm > 0 are split evenly. Inner points are on a triangular grid of that spacing, as near to
// the boundary as gives well-shaped triangles. Points at the same place count as one. Depends only
// on the input. Returns nullopt if edges cross.
std::optional<RegionMesh> meshRegion(const std::vector<Eigen::Vector2d>& points,
                                     const std::vector<std::array<int, 2>>& edges, double edgeMm);

} // namespace voluta::planar
