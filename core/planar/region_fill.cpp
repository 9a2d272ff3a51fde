#include "planar/region_fill.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <vector>

namespace voluta::planar {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr int kUnseen = -1;

// Counts crossed constraints from the infinite face: odd is inside.
void markInside(Triangulation& t) {
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
}

} // namespace

std::optional<std::vector<std::array<int, 3>>>
fillRegion(const std::vector<Eigen::Vector2d>& points,
           const std::vector<std::array<int, 2>>& edges) {
  std::vector<std::array<int, 2>> once;
  for (const auto& e : edges)
    once.push_back({std::min(e[0], e[1]), std::max(e[0], e[1])});
  std::sort(once.begin(), once.end());
  std::vector<std::array<int, 2>> odd;
  for (std::size_t begin = 0; begin < once.size();) {
    std::size_t end = begin;
    while (end < once.size() && once[end] == once[begin])
      ++end;
    if ((end - begin) % 2 == 1)
      odd.push_back(once[begin]);
    begin = end;
  }

  Triangulation t;
  std::vector<Triangulation::Vertex_handle> vertex(points.size());
  const auto vertexOf = [&](int i) {
    auto& known = vertex[static_cast<std::size_t>(i)];
    if (known == nullptr) {
      const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
      const std::size_t before = t.number_of_vertices();
      const auto inserted = t.insert(Kernel::Point_2(p.x(), p.y()));
      if (t.number_of_vertices() == before)
        return Triangulation::Vertex_handle{};
      inserted->info() = i;
      known = inserted;
    }
    return known;
  };
  try {
    for (const auto& e : odd) {
      const auto a = vertexOf(e[0]), b = vertexOf(e[1]);
      if (a == nullptr || b == nullptr)
        return std::nullopt;
      t.insert_constraint(a, b);
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  std::vector<std::array<int, 3>> triangles;
  if (t.dimension() < 2)
    return triangles;
  markInside(t);
  for (const auto face : t.finite_face_handles())
    if (face->info() == 1)
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

} // namespace voluta::planar
