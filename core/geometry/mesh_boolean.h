// Union and difference of closed meshes in one place: CGAL's corefinement is compiled once for
// both.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>

namespace voluta::geometry {

enum class BooleanOperation { Union, Difference };

// What the operation makes of two meshes (CGAL Polygon_mesh_processing, corefinement). Nothing
// where one of them is no closed, oriented manifold or the result is none, and where CGAL finds a
// precondition broken, among them, with `refuseSelfIntersections`, a mesh that cuts itself where
// the two meet.
std::optional<TriangleMesh> meshBoolean(BooleanOperation operation, const TriangleMesh& first,
                                        const TriangleMesh& second, bool refuseSelfIntersections);

} // namespace voluta::geometry
