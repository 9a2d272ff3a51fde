// Where the nozzle comes from at each waypoint.
#pragma once

#include "collision/growing_part.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Is a path not laid where no direction is clear, rather than told?
using MayMiss = std::function<bool(const plan::ToolPath&)>;

struct OrientResult {
  plan::ToolPlan plan;
  std::size_t gouges = 0;    // waypoints of the result at which the head isn't clear
  double maxTurnDeg = 0.0;   // between neighbouring waypoints of a path
  std::vector<char> gouging; // per waypoint: the head isn't clear
  std::vector<char> hanging; // per waypoint: nothing carries its bead (bridges.h)
  plan::Findings findings;   // stage "toolpath", kinds "gouge" and "braced"
  // Of the plan, at collision::growingPitch(), with the platform as its ground.
  std::shared_ptr<const collision::GrowingPart> grown = {};
};

// Keeps each waypoint's direction (that of its layer: Dai eq. 3.3 with the closest point of the
// layer before, which the level surfaces' gradient is) where head and holder clear the plate, what
// carries it and what is printed before, and leans it towards its clear direction only as far as it
// must, else towards whatever nearby clears, up to 75 degrees from its own; low-passes along the
// path where neighbours differ by more than smoothBeyondDeg (Dai 3.5.2) unless that gouges;
// subdivides steps that turn more than turnLimitDeg. Walls that would hang are laid a little aside
// (inset_walls.h); else the middle of each bead stays where it is: tip = middle + 1/2 height x
// direction. What hangs all the same leans where its neighbour then holds it (tilt_unsupported.h), unless the
// plan is upright throughout: then it stays so. Gone over up to four times while less and less
// gouges.
// Before it is gone over again, paths that mayMiss lose the waypoints that gouge.
// clearDirection: per waypoint, unit. `grown`: the plan's beads at collision::growingPitch(), where
// platform is no body and no rod; null: they are deposited here. Preconditions: sizes match.
// Throws Cancelled.
OrientResult orientDirections(const plan::ToolPlan& plan,
                              const std::vector<Eigen::Vector3d>& clearDirection,
                              const robot::Cell& cell, const process::Process& process,
                              const ToolpathOptions& options, const base::RunContext& ctx,
                              const MayMiss& mayMiss = {},
                              std::shared_ptr<const collision::GrowingPart> grown = {});

} // namespace voluta::toolpath
