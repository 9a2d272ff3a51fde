#include "geometry/subtract.h"

#include "geometry/mesh_boolean.h"

namespace voluta::geometry {

std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other) {
  if (other.empty())
    return part;
  // A part that cuts itself has no inside to take away from.
  return meshBoolean(BooleanOperation::Difference, part, other, true);
}

} // namespace voluta::geometry
