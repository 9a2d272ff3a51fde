// Triangles of about one size that fill a region of the plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace voluta::planar {

struct RegionMesh {
  // The points given, then `splits`, then points inside.
  std::vector<Eigen::Vector2d> points;
  struct Split {
    int a, b; // points given
    double t; // (1 - t) a + t b
  };
  std::vector<Split> splits;
  std::vector<std::array<int, 3>> triangles; // counter-clockwise
};

// Constrained Delaunay triangulation of the region inside the `edges` (index pairs into `points`)
// by the rule of fillRegion: odd is inside. The boundary stays where it is: edges longer than
// edgeMm > 0 are split evenly. Inside stand points on a triangular grid of that spacing, as near to
// the boundary as gives well-shaped triangles. Points at the same place count as one. Depends only
// on the input. Nothing where edges cross.
std::optional<RegionMesh> meshRegion(const std::vector<Eigen::Vector2d>& points,
                                     const std::vector<std::array<int, 2>>& edges, double edgeMm);

} // namespace voluta::planar
