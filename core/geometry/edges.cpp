#include "geometry/edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace voluta::geometry {

namespace {

// Sorts by the high vertex; stable.
void sortFew(std::vector<HalfEdge>::iterator begin, std::vector<HalfEdge>::iterator end) {
  constexpr std::ptrdiff_t kFew = 24;
  if (end - begin > kFew) {
    std::stable_sort(begin, end,
                     [](const HalfEdge& a, const HalfEdge& b) { return a.high < b.high; });
    return;
  }
  for (auto at = begin; at != end; ++at)
    for (auto to = at; to != begin && to->high < (to - 1)->high; --to)
      std::swap(*to, *(to - 1));
}

} // namespace

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  // Counting sort by the low vertex; few edges share one, in the order of triangles and sides.
  std::vector<std::uint32_t> next(mesh.vertices.size() + 1, 0);
  const auto eachSide = [&](auto&& visit) {
    for (const int t : triangles) {
      const std::array<int, 3>& corner = mesh.triangles[static_cast<std::size_t>(t)];
      for (int side = 0; side < 3; ++side) {
        const int from = corner[static_cast<std::size_t>(side)],
                  to = corner[static_cast<std::size_t>((side + 1) % 3)];
        visit(HalfEdge{std::min(from, to), std::max(from, to), t, side, from < to});
      }
    }
  };
  eachSide([&](const HalfEdge& edge) { ++next[static_cast<std::size_t>(edge.low) + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<HalfEdge> edges(3 * triangles.size());
  eachSide([&](const HalfEdge& edge) { edges[next[static_cast<std::size_t>(edge.low)]++] = edge; });
  // Each entry of `next` is now at the start of the following vertex.
  std::uint32_t begin = 0;
  for (std::size_t v = 0; v + 1 < next.size(); begin = next[v++])
    sortFew(edges.begin() + begin, edges.begin() + next[v]);
  return edges;
}

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh) {
  std::vector<int> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return sortedHalfEdges(mesh, all);
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
