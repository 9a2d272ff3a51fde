#include "geometry/subtract.h"

#include "geometry/mesh_boolean.h"

namespace voluta::geometry {

std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other) {
  if (other.empty())
    return part;
  // Fails for a part that intersects itself, which has no well-defined inside.
  return meshBoolean(BooleanOperation::Difference, part, other, true);
}

} // namespace voluta::geometry
