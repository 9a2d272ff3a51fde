// How thick a solid is at its surface.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/published/skeleton.h"

#include <vector>

namespace voluta::planar {

// For each triangle the distance from its middle to the nearest point of the skeleton, mm (RoboFDM,
// phase I, step 2). All zero where there is no skeleton. Throws Cancelled.
std::vector<double> shapeDiameters(const geometry::TriangleMesh& mesh,
                                   const CurveSkeleton& skeleton, const base::RunContext& ctx);

} // namespace voluta::planar
