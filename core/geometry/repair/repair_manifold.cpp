#include "geometry/repair/repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

namespace voluta::geometry {

std::size_t separateNonManifold(TriangleMesh& mesh) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (const auto& v : mesh.vertices)
    points.emplace_back(v.x(), v.y(), v.z());
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& t : mesh.triangles)
    faces.push_back({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                     static_cast<std::size_t>(t[2])});
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);
  const std::size_t added = points.size() - mesh.vertices.size();
  mesh.vertices.clear();
  for (const auto& p : points)
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  for (std::size_t t = 0; t < faces.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles[t][k] = static_cast<int>(faces[t][k]);
  return added;
}

} // namespace voluta::geometry
