// Beads that nothing beneath carries, pressed against those beside them.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "toolpath/unsupported/bridges.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Where a layer begins at a chin or on a rim, it reaches out over what is printed by several beads,
// and none but the innermost has anything beneath it. An arm that leans outwards there presses each
// bead against the one that lies inwards of it, which therefore comes first. A plan whose beads are
// upright throughout (flat layers), but for supports, stays as it is: its cell, or who reads its
// program, may know nothing else.

struct OrderedPath {
  std::size_t path = 0;
  bool turned = false; // laid from its end to its beginning
  bool operator==(const OrderedPath&) const = default;
};
// The order of the plan's paths in which this can be: of a patch, what has stretches that hang for
// longer than half of what the process bridges comes last, and of that first what lies nearest to
// what does not hang. Such a path is turned where that lays the lines of it that lie beside its
// stretches before them rather than after. Else, and in patches of which all hangs or that are
// supports: as it is. `hanging`: unsupportedWaypoints().
std::vector<OrderedPath> orderInsideOut(const plan::ToolPlan& plan,
                                        const std::vector<char>& hanging,
                                        const process::Process& process);

// Is there any such stretch that braced() would look at?
bool canBrace(const plan::ToolPlan& plan, const std::vector<char>& hanging,
              const process::Process& process);

// Per waypoint, the direction to lay it along: its own, but leaning to the side by as little as
// brings a quarter of a bead's width over something (kMinSupportedSamples), by 50 degrees at most,
// where a stretch longer than half of what the process bridges hangs; gently along the path. The
// middle of the bead stays where it is. Where leaning does not help, nothing does; no support
// leans. `hanging`: unsupportedWaypoints() with kMinSupportedSamples. Throws Cancelled.
std::vector<Eigen::Vector3d>
tiltUnsupportedBeads(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     const process::Process& process, const base::RunContext& ctx);

} // namespace voluta::toolpath
