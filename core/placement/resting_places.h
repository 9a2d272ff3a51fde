// What a part can lie on: the faces of its convex hull.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::placement {

// Outward unit normals of the faces of the mesh's convex hull, the largest face first, at most
// `most`. Facets of the hull within three degrees of a larger one count to its face; its normal is
// their mean by area. Turns with the mesh, but for the order of faces of equal size. A mesh in one
// plane has none. Precondition (Error{Internal}): mesh not empty.
std::vector<Eigen::Vector3d> restingPlaces(const geometry::TriangleMesh& mesh, std::size_t most);

} // namespace voluta::placement
