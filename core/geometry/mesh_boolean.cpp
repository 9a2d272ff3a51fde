#include "geometry/mesh_boolean.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/boost/graph/helpers.h>
#include <exception>

namespace voluta::geometry {

std::optional<TriangleMesh> meshBoolean(BooleanOperation operation, const TriangleMesh& first,
                                        const TriangleMesh& second, bool refuseSelfIntersections) {
  auto a = toCgal(first), b = toCgal(second);
  if (!a || !b || !CGAL::is_closed(*a) || !CGAL::is_closed(*b))
    return std::nullopt;
  namespace pmp = CGAL::Polygon_mesh_processing;
  // Corefinement crashes on triangles without area, which its own results may contain.
  if (!pmp::remove_degenerate_faces(*a) || !pmp::remove_degenerate_faces(*b))
    return std::nullopt;
  CgalMesh result;
  const auto strictly = CGAL::parameters::throw_on_self_intersection(refuseSelfIntersections);
  try {
    const bool made = operation == BooleanOperation::Union
                          ? pmp::corefine_and_compute_union(*a, *b, result, strictly)
                      : operation == BooleanOperation::Intersection
                          ? pmp::corefine_and_compute_intersection(*a, *b, result, strictly)
                          : pmp::corefine_and_compute_difference(*a, *b, result, strictly);
    if (!made)
      return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return fromCgal(result);
}

} // namespace voluta::geometry
