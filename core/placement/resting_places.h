// The faces of a part's convex hull on which it can rest.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::placement {

// Returns outward unit normals of the faces of the mesh's convex hull, largest first, at most
// `maxCount`. Facets of the hull within three degrees of a larger one belong to its face, whose
// normal is their area-weighted mean. The result rotates with the mesh, except for the order of
// faces of equal size. A planar mesh has none. Precondition (Error{Internal}): mesh not empty.
std::vector<Eigen::Vector3d> restingPlaces(const geometry::TriangleMesh& mesh,
                                           std::size_t maxCount);

} // namespace voluta::placement
