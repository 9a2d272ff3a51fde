// The undirected edges of a mesh with their triangles.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>
#include <vector>

namespace voluta::geometry {

// Side `side` of `triangle` runs from corner `side` to corner (side + 1) % 3.
struct HalfEdge {
  int low = 0, high = 0; // vertices, low <= high
  int triangle = 0;
  int side = 0;
  bool forward = true; // runs from low to high
};

// Returns all 3 n sides, sorted by (low, high, triangle, side), so that those of one edge are
// adjacent.
std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh);
// Same for a subset of triangles, in ascending order.
std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh, const std::vector<int>& triangles);

// Calls body(begin, end) for the half-edges of each edge.
template <typename Body> void forEachEdge(const std::vector<HalfEdge>& sorted, Body&& body) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].low == sorted[begin].low &&
           sorted[end].high == sorted[begin].high)
      ++end;
    body(begin, end);
    begin = end;
  }
}

// Disjoint sets with path halving.
class UnionFind {
public:
  explicit UnionFind(std::size_t size);
  int find(int item);
  // Joins the sets of a and b under the smaller root. Returns false if they were one set already.
  bool join(int a, int b);

private:
  std::vector<int> parent_;
};

} // namespace voluta::geometry
