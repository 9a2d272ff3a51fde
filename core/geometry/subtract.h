// One solid less another.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>

namespace voluta::geometry {

// What of `part` lies outside `other`: closed, outward, cut exactly along where the two meet
// (corefinement; Loriot et al., CGAL Polygon_mesh_processing). Empty where nothing is left. Nothing
// where either is not closed, or the part cuts itself where the two meet.
std::optional<TriangleMesh> subtract(const TriangleMesh& part, const TriangleMesh& other);

} // namespace voluta::geometry
