// Tilts unsupported beads so that they are pressed against their neighbours.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "toolpath/unsupported/bridges.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Where a layer begins at a chin or on a rim, it overhangs the printed part by several beads, of
// which only the innermost is supported. An arm tilted outwards presses each bead against its inner
// neighbour, which therefore has to be printed first. Plans that are upright throughout except for
// supports (flat layers) are not changed: their cell, or the reader of their program, may support
// no tilt.

struct OrderedPath {
  std::size_t path = 0;
  bool turned = false; // printed from its end to its beginning
  bool operator==(const OrderedPath&) const = default;
};
// Returns the order of the plan's paths that makes this possible. Within a patch, paths with
// unsupported stretches longer than half of the process's bridge length come last, ordered by their
// distance from supported beads. Such a path is reversed if that prints the lines beside its
// stretches before the stretches. Otherwise, and in patches that are entirely unsupported or
// supports, the order is unchanged. `hanging`: unsupportedWaypoints().
std::vector<OrderedPath> orderInsideOut(const plan::ToolPlan& plan,
                                        const std::vector<char>& hanging,
                                        const process::Tooling& tooling);

// Returns whether there is any stretch that tiltUnsupportedBeads() would tilt.
bool canBrace(const plan::ToolPlan& plan, const std::vector<char>& hanging,
              const process::Tooling& tooling);

// Returns the direction per waypoint: its own, except in unsupported stretches longer than half of
// the process's bridge length. There it is tilted sideways by the minimum angle that supports a
// quarter of the bead's width (kMinSupportedSamples), at most 50 degrees, tapered along the path.
// The middle of the bead stays in place. Not tilted where that does not help, nor for supports.
// `hanging`: unsupportedWaypoints() with kMinSupportedSamples. Throws Cancelled.
std::vector<Eigen::Vector3d>
tiltUnsupportedBeads(const plan::ToolPlan& plan, const std::vector<char>& hanging,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     const process::Tooling& tooling, const base::RunContext& ctx);

} // namespace voluta::toolpath
