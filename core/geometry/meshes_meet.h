// Whether two closed meshes touch or share volume.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <optional>

namespace voluta::geometry {

// Returns a point where the surfaces of two meshes intersect, or a vertex of one mesh inside the
// other one; nullopt if the meshes are apart.
std::optional<Eigen::Vector3d> meetingPoint(const TriangleMesh& a, const TriangleMesh& b);

// Returns a point more than `depthMm` inside both meshes; nullopt if there is none, as between
// meshes that only touch. Looks along the edges of both and below the middles of their triangles.
// Precondition: depthMm > 0.
std::optional<Eigen::Vector3d> sharedPoint(const TriangleMesh& a, const TriangleMesh& b,
                                           double depthMm);

// Returns the distance from the corners and the middles of the sides of each mesh to the other one
// [mm]: the meshes' distance, or a little more where two sides cross.
double distanceBetween(const TriangleMesh& a, const TriangleMesh& b);

} // namespace voluta::geometry
