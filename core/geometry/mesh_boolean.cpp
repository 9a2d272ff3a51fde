#include "geometry/mesh_boolean.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <array>
#include <boost/optional.hpp>
#include <exception>

namespace voluta::geometry {

std::optional<CgalMesh> meshBoolean(BooleanOperation operation, CgalMesh& first, CgalMesh& second,
                                    bool refuseSelfIntersections) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  const std::size_t slot = operation == BooleanOperation::Union ? pmp::Corefinement::UNION
                                                                : pmp::Corefinement::TM1_MINUS_TM2;
  CgalMesh result;
  std::array<boost::optional<CgalMesh*>, 4> wanted;
  wanted[slot] = &result;
  try {
    const std::array<bool, 4> made = pmp::corefine_and_compute_boolean_operations(
        first, second, wanted,
        CGAL::parameters::throw_on_self_intersection(refuseSelfIntersections));
    if (!made[slot])
      return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return result;
}

} // namespace voluta::geometry
