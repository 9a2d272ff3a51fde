// Union and difference of closed meshes in one place: CGAL's corefinement is compiled once for both.
// For .cpp files only.
#pragma once

#include "geometry/cgal_mesh.h"

#include <optional>

namespace voluta::geometry {

enum class BooleanOperation { Union, Difference };

// What the operation makes of `first` and `second` (CGAL Polygon_mesh_processing, corefinement);
// both are refined on the way. Nothing where the result is no manifold, and where CGAL finds a
// precondition broken, among them, with `refuseSelfIntersections`, a mesh that cuts itself where
// the two meet. Precondition: closed, oriented.
std::optional<CgalMesh> meshBoolean(BooleanOperation operation, CgalMesh& first, CgalMesh& second,
                                    bool refuseSelfIntersections);

} // namespace voluta::geometry
