// Conversion to and from CGAL's half-edge mesh; for .cpp files only.
#pragma once

#include "geometry/triangle_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <optional>

namespace voluta::geometry {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

// Returns nullopt if the triangles are not an oriented manifold. Vertices without triangles are
// omitted.
inline std::optional<CgalMesh> toCgal(const TriangleMesh& mesh) {
  CgalMesh out;
  std::vector<CgalMesh::Vertex_index> vertices(mesh.vertices.size());
  const auto vertex = [&](int v) {
    auto& known = vertices[static_cast<std::size_t>(v)];
    const Eigen::Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
    if (known == CgalMesh::null_vertex())
      known = out.add_vertex(CgalKernel::Point_3(p.x(), p.y(), p.z()));
    return known;
  };
  for (const auto& t : mesh.triangles) {
    const auto a = vertex(t[0]), b = vertex(t[1]), c = vertex(t[2]);
    if (out.add_face(a, b, c) == CgalMesh::null_face())
      return std::nullopt;
  }
  return out;
}

inline TriangleMesh fromCgal(const CgalMesh& mesh) {
  TriangleMesh out;
  std::vector<int> index(mesh.num_vertices() + mesh.number_of_removed_vertices(), -1);
  for (const auto v : mesh.vertices()) {
    index[v.idx()] = static_cast<int>(out.vertices.size());
    const auto& p = mesh.point(v);
    out.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    std::array<int, 3> t{};
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      t[k++] = index[v.idx()];
    out.triangles.push_back(t);
  }
  return out;
}

} // namespace voluta::geometry
