// Whether two closed meshes share volume.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <optional>

namespace voluta::geometry {

// Returns a point where the surfaces of two meshes intersect, or a vertex of one mesh inside the
// other one; nullopt if the meshes are apart.
std::optional<Eigen::Vector3d> meetingPoint(const TriangleMesh& a, const TriangleMesh& b);

} // namespace voluta::geometry
