#include "geometry/subtract.h"

#include "geometry/mesh_boolean.h"

#include <CGAL/boost/graph/helpers.h>

namespace voluta::geometry {

std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other) {
  if (other.empty())
    return part;
  auto first = toCgal(part), second = toCgal(other);
  if (!first || !second || !CGAL::is_closed(*first) || !CGAL::is_closed(*second))
    return std::nullopt;
  // A part that cuts itself has no inside to take away from.
  const std::optional<CgalMesh> difference =
      meshBoolean(BooleanOperation::Difference, *first, *second, true);
  return difference ? std::optional(fromCgal(*difference)) : std::nullopt;
}

} // namespace voluta::geometry
