// Insets unsupported walls to where the layer below supports them.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "toolpath/unsupported/bridges.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Where the rim of a layer overhangs that of the layer below by more than the widest bead
// (supported_walls.h), its wall would be printed beside the part. Stretches that are supported over
// less than a quarter of their width (kMinSupportedSamples) and are longer than half of the
// process's bridge length are therefore offset sideways: by the minimum that supports a quarter of
// the width, at most half a bead, tapered along the path. Where that is not enough they are not
// moved. An offset bead overlaps its neighbour, and the part is short, by the same amount. Returns
// the offset per waypoint [mm]; walls only. `hanging`: unsupportedWaypoints() with
// kMinSupportedSamples. Throws Cancelled.
std::vector<Eigen::Vector3d>
insetUnsupportedWalls(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                      const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                      const process::Tooling& tooling, const base::RunContext& ctx);

} // namespace voluta::toolpath
