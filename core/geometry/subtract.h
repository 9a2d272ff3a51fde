// Difference of two solids.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>

namespace voluta::geometry {

// Returns `part` minus `other`: closed, facing outward, cut exactly along their intersection
// (corefinement; Loriot et al., CGAL Polygon_mesh_processing). Empty if nothing is left. Returns
// nullopt if either is not closed, or the part intersects itself near the cut.
std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other);

} // namespace voluta::geometry
