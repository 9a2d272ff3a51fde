#include "geometry/edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace voluta::geometry {

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const int from = mesh.triangles[t][static_cast<std::size_t>(side)];
      const int to = mesh.triangles[t][static_cast<std::size_t>((side + 1) % 3)];
      edges.push_back(
          {std::min(from, to), std::max(from, to), static_cast<int>(t), side, from < to});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) <
           std::tie(b.low, b.high, b.triangle, b.side);
  });
  return edges;
}

UnionFind::UnionFind(std::size_t size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int UnionFind::find(int item) {
  auto i = static_cast<std::size_t>(item);
  while (parent_[i] != static_cast<int>(i)) {
    parent_[i] = parent_[static_cast<std::size_t>(parent_[i])];
    i = static_cast<std::size_t>(parent_[i]);
  }
  return static_cast<int>(i);
}

bool UnionFind::join(int a, int b) {
  a = find(a);
  b = find(b);
  if (a == b)
    return false;
  parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  return true;
}

} // namespace voluta::geometry
