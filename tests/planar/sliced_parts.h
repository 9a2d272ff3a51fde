// Parts and sums that tests of slicing share.
#pragma once

#include "planar/slicing/region_mesh.h"
#include "planar/slicing/slicing.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::planar {

inline Piece pieceOf(const geometry::TriangleMesh& mesh) {
  Piece piece;
  piece.solid = tagged(mesh);
  return piece;
}

// A prism over the polygon (x, z), counter-clockwise, from y = 0 to y = depth.
inline geometry::TriangleMesh prism(const std::vector<Eigen::Vector2d>& profile, double depth) {
  std::vector<std::array<int, 2>> edges;
  const int n = static_cast<int>(profile.size());
  for (int i = 0; i < n; ++i)
    edges.push_back({i, (i + 1) % n});
  const auto region = meshRegion(profile, edges, 1e6);
  geometry::TriangleMesh m;
  for (const double y : {0.0, depth})
    for (const auto& p : profile)
      m.vertices.emplace_back(p.x(), y, p.y());
  for (const auto& t : region->triangles) {
    m.triangles.push_back({t[0], t[1], t[2]});
    m.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  }
  for (const auto& e : edges) {
    m.triangles.push_back({e[0], e[0] + n, e[1] + n});
    m.triangles.push_back({e[0], e[1] + n, e[1]});
  }
  return m;
}

// A gallows: a post of 10 x 10 x 16 with an arm of 10 x 10 x 4 from x = 10 to 20.
inline geometry::TriangleMesh gallows() {
  return prism({{0, 0}, {10, 0}, {10, 16}, {20, 16}, {20, 20}, {0, 20}}, 10.0);
}

inline double volumeOf(const SliceResult& sliced) {
  double sum = 0.0;
  for (const double v : sliced.volumeOfPiece)
    sum += v;
  return sum;
}

} // namespace voluta::planar
