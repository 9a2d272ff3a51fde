// Local thickness of a solid at its surface.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/published/skeleton.h"

#include <vector>

namespace voluta::planar {

// Returns the distance from each triangle's centroid to the nearest point of the skeleton [mm]
// (RoboFDM, phase I, step 2). All zero without a skeleton. Throws Cancelled.
std::vector<double> shapeDiameters(const geometry::TriangleMesh& mesh,
                                   const CurveSkeleton& skeleton, const base::RunContext& ctx);

} // namespace voluta::planar
