// How regions look in the view.
#pragma once

#include "geometry/triangle_mesh.h"
#include "project/region.h"
#include "scene/drawings.h"

#include <Eigen/Geometry>

namespace voluta::window {

// Throws Error{Usage} for a use that does not exist.
scene::RegionLook lookOf(const project::Region& region);

// Returns a painted surface in the work frame, slightly over the part. `scale`: from the file's
// lengths to mm.
geometry::TriangleMesh overPart(const geometry::TriangleMesh& painted,
                                const Eigen::Isometry3d& work_T_file, double scale);

} // namespace voluta::window
