#include "geometry/remesh.h"

#include "geometry/cgal_mesh.h"
#include "geometry/measures.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voluta::geometry {

TriangleMesh remeshed(const TriangleMesh& mesh, std::size_t triangles) {
  constexpr unsigned kPasses = 3;
  std::optional<CgalMesh> cgal = toCgal(mesh);
  if (!cgal || mesh.empty())
    return mesh;
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
      faces(*cgal), evenEdge(mesh, triangles), *cgal,
      CGAL::parameters::number_of_iterations(kPasses));
  cgal->collect_garbage();
  return fromCgal(*cgal);
}

double longestEdge(const TriangleMesh& mesh) {
  double longest = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).norm());
  return longest;
}

double evenEdge(const TriangleMesh& mesh, std::size_t triangles) {
  const double each = area(mesh) / static_cast<double>(std::max<std::size_t>(triangles, 1));
  return std::sqrt(4.0 * each / std::numbers::sqrt3);
}

} // namespace voluta::geometry
