#include "geometry/mesh_boolean.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/boost/graph/helpers.h>
#include <array>
#include <boost/optional.hpp>
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
  const std::size_t slot = operation == BooleanOperation::Union ? pmp::Corefinement::UNION
                           : operation == BooleanOperation::Intersection
                               ? pmp::Corefinement::INTERSECTION
                               : pmp::Corefinement::TM1_MINUS_TM2;
  CgalMesh result;
  std::array<boost::optional<CgalMesh*>, 4> wanted;
  wanted[slot] = &result;
  try {
    const std::array<bool, 4> made = pmp::corefine_and_compute_boolean_operations(
        *a, *b, wanted, CGAL::parameters::throw_on_self_intersection(refuseSelfIntersections));
    if (!made[slot])
      return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return fromCgal(result);
}

} // namespace voluta::geometry
