#include "geometry/subtract.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/boost/graph/helpers.h>
#include <exception>

namespace voluta::geometry {

std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other) {
  if (other.empty())
    return part;
  auto first = toCgal(part), second = toCgal(other);
  if (!first || !second || !CGAL::is_closed(*first) || !CGAL::is_closed(*second))
    return std::nullopt;
  CgalMesh difference;
  try {
    namespace pmp = CGAL::Polygon_mesh_processing;
    if (!pmp::corefine_and_compute_difference(*first, *second, difference,
                                              CGAL::parameters::throw_on_self_intersection(true)))
      return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt; // a part that cuts itself, or a precondition that CGAL found broken
  }
  return fromCgal(difference);
}

} // namespace voluta::geometry
