// Which beads hang: spans that nothing printed before carries, known before anything is moved.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Per waypoint, 1: neither the platform nor what is laid before lies right beneath the bead, at any
// of eight places across its width (at fewer than `leastPlaces`), within its height and a quarter
// more below the tip. Stretches of a path shorter than a bead's width
// do not count, neither do such breaks of longer ones, nor what is waste. `part`: the plan's beads
// with its ground. Throws Cancelled.
std::vector<char> unsupportedWaypoints(const plan::ToolPlan& plan,
                                       const collision::GrowingPart& part,
                                       const platform::PlatformSolid& platform,
                                       const base::RunContext& ctx, int leastPlaces = 1);

// Waypoints [begin, end) of a path that all hang.
struct UnsupportedStretch {
  std::size_t begin = 0, end = 0;
};
// Those of a path that are longer, in order.
std::vector<UnsupportedStretch> hangingStretches(const plan::ToolPlan& plan,
                                                 const plan::ToolPath& path,
                                                 const std::vector<char>& hanging,
                                                 double longerThanMm);

// How many of kPlacesAcross places across a bead are carried, as above, if the nozzle lays it with
// its tip there, along that direction. Counts no further than `enough`.
inline constexpr int kPlacesAcross = 8;        // as programs are judged
inline constexpr int kMinSupportedSamples = 2; // of them: a quarter of the width
int supportedSamples(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t waypoint,
                     const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     int enough = kPlacesAcross);
// To the side of the way at a waypoint: direction x way, unit.
Eigen::Vector3d sideOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                       std::size_t waypoint);

// Lays what hangs, and what leads to and from it, no faster than the process bridges; what comes
// out stays in proportion, as planned speeds and sections say.
void slowBridges(plan::ToolPlan& plan, const std::vector<char>& hanging,
                 const process::Process& process);

} // namespace voluta::toolpath
