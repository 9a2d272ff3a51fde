// Union, difference and intersection of closed meshes; compiles CGAL's corefinement once for all.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>

namespace voluta::geometry {

enum class BooleanOperation { Union, Difference, Intersection };

// Returns the result of the operation on two meshes (CGAL Polygon_mesh_processing, corefinement).
// Triangles without area are removed first. Returns nullopt if one of the meshes or the result is
// not a closed, oriented manifold, and if CGAL finds a broken precondition, including, with
// `refuseSelfIntersections`, self-intersections where the two meshes intersect.
std::optional<TriangleMesh> meshBoolean(BooleanOperation operation, const TriangleMesh& first,
                                        const TriangleMesh& second, bool refuseSelfIntersections);

} // namespace voluta::geometry
