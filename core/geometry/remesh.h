// Meshes with triangles of even size, for methods that need vertices everywhere on a surface.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>

namespace voluta::geometry {

// Returns the surface with about `triangles` nearly equilateral triangles, its vertices on the
// given one (Botsch and Kobbelt 2004; CGAL Polygon_mesh_processing). Sharp edges may be cut by up
// to half an edge. A mesh that is not manifold is returned unchanged.
TriangleMesh remeshed(const TriangleMesh& mesh, std::size_t triangles);

// Returns the length of the longest edge [mm]; 0 for an empty mesh.
double longestEdge(const TriangleMesh& mesh);

// Returns the edge of equilateral triangles, as many as given, that cover a surface [mm].
double evenEdge(const TriangleMesh& mesh, std::size_t triangles);

} // namespace voluta::geometry
