// Constrained Delaunay triangulation (CGAL) for filling regions of the plane; include in .cpp files
// only.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace voluta::layers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
// Each vertex holds the index of its point. Constraints must not cross.
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

// Returns the edges that occur an odd number of times in either direction: lower index first,
// sorted.
inline std::vector<std::array<int, 2>> oddEdges(std::vector<std::array<int, 2>> edges) {
  for (auto& e : edges)
    if (e[0] > e[1])
      std::swap(e[0], e[1]);
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<int, 2>> odd;
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end] == edges[begin])
      ++end;
    if ((end - begin) % 2 == 1)
      odd.push_back(edges[begin]);
    begin = end;
  }
  return odd;
}

// Returns the triangles inside the region: those separated from the infinite face by an odd number
// of constraints.
inline std::vector<std::array<int, 3>> insideTriangles(Triangulation& t) {
  std::vector<std::array<int, 3>> triangles;
  if (t.dimension() < 2)
    return triangles;
  constexpr int kUnseen = -1;
  for (const auto face : t.all_face_handles())
    face->info() = kUnseen;
  std::vector<Triangulation::Face_handle> open{t.infinite_face()};
  open.front()->info() = 0;
  while (!open.empty()) {
    const auto face = open.back();
    open.pop_back();
    for (int side = 0; side < 3; ++side) {
      const auto next = face->neighbor(side);
      if (next->info() != kUnseen)
        continue;
      next->info() = face->info() ^ (face->is_constrained(side) ? 1 : 0);
      open.push_back(next);
    }
  }
  for (const auto face : t.finite_face_handles())
    if (face->info() == 1)
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

} // namespace voluta::layers
