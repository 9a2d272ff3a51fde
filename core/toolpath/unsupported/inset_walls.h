// Walls that would hang, laid a little aside where something carries them.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "toolpath/unsupported/bridges.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Where the rim of a layer is more than the widest bead beyond that of the layer below
// (supported_walls.h), its wall would be laid beside what is printed. So a stretch of which less than
// a quarter is carried (kMinSupportedSamples), longer than half of what the process bridges, is
// laid aside: as little as brings a quarter of its width over something, by half a bead at most,
// gently along the path. Where that is not enough it stays. It lies on its neighbour by as much,
// and the part is by as much short there. Per waypoint, mm; walls only. `hanging`:
// unsupportedWaypoints() with kMinSupportedSamples. Throws Cancelled.
std::vector<Eigen::Vector3d>
insetUnsupportedWalls(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                      const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                      const process::Process& process, const base::RunContext& ctx);

} // namespace voluta::toolpath
