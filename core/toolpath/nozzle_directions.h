// Computes the nozzle direction at each waypoint.
#pragma once

#include "plan/finding.h"
#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::toolpath {

struct ToolpathOptions;

// Returns whether a path is skipped, rather than reported, where no direction is clear.
using MayMiss = std::function<bool(const plan::ToolPath&)>;

struct OrientResult {
  plan::ToolPlan plan;
  std::size_t gouges = 0;      // Number of waypoints of the result at which the head is not clear
  double maxRotationDeg = 0.0; // Between neighbouring waypoints of a path
  std::vector<char> gouging;   // Per waypoint: the head is not clear
  plan::Findings findings;     // Stage "toolpath", kind "gouge" and those of the passes
  // The beads of the plan at collision::growingPitch(), with the platform as the ground.
  std::shared_ptr<const collision::GrowingPart> grown = {};
};

// Computes the nozzle direction of each waypoint. Starts from the layer's direction (Dai eq. 3.3
// uses the closest point of the previous layer, which equals the gradient of the level surfaces).
// Keeps it where head and holder clear the plate, the substrate and the part printed so far; else
// tilts it towards its clear direction as little as possible, else towards any clear direction up
// to 75 degrees away. Low-passes along the path where neighbours differ by more than
// smoothBeyondDeg (Dai 3.5.2), unless that gouges. Subdivides steps that turn by more than
// maxBendDeg. The passes over unsupported beads (passes.h, WithDirections) move the middles of
// beads, and tilt directions, which are then tried first; otherwise the middle of each bead stays
// in place: tip = middle + 1/2 height x direction. Repeats up to four times as long as the number
// of gouging waypoints decreases. Before each repetition, paths that satisfy mayMiss lose their
// gouging waypoints. clearDirection: per waypoint, unit vector. `grown`: the plan's beads at
// collision::growingPitch() if the platform is neither a body nor a rod; nullptr: they are
// deposited here. Precondition: sizes match. Throws Cancelled.
OrientResult orientDirections(const plan::ToolPlan& plan,
                              const std::vector<Eigen::Vector3d>& clearDirection,
                              const robot::Cell& cell, const process::Tooling& tooling,
                              const ToolpathOptions& options, const base::RunContext& ctx,
                              const MayMiss& mayMiss = {},
                              std::shared_ptr<const collision::GrowingPart> grown = {});

} // namespace voluta::toolpath
