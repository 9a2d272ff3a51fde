#include "geometry/edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace voluta::geometry {

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh) {
  const auto sideOf = [&](std::size_t t, int side) {
    const int from = mesh.triangles[t][static_cast<std::size_t>(side)];
    const int to = mesh.triangles[t][static_cast<std::size_t>((side + 1) % 3)];
    return HalfEdge{std::min(from, to), std::max(from, to), static_cast<int>(t), side, from < to};
  };
  // By the low vertex first, counted; few share one.
  std::vector<std::size_t> begin(mesh.vertices.size() + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side)
      ++begin[static_cast<std::size_t>(sideOf(t, side).low) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v)
    begin[v] += begin[v - 1];
  std::vector<HalfEdge> edges(3 * mesh.triangles.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const HalfEdge edge = sideOf(t, side);
      edges[next[static_cast<std::size_t>(edge.low)]++] = edge;
    }
  for (std::size_t v = 0; v + 1 < begin.size(); ++v)
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              edges.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.triangle, a.side) < std::tie(b.high, b.triangle, b.side);
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
