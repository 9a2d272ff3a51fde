// Beads of support under beads that would hang just over the plate or over what is printed.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// A plan before directions are sought, with what assemble() knows of each waypoint.
struct RimSupportedPlan {
  plan::ToolPlan plan;
  std::vector<Eigen::Vector3d> clearDirection;     // per waypoint
  std::size_t underlaid = 0;                       // paths that got beads beneath
  double volumeMm3 = 0.0;                          // of these beads
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // of the first; meaningless where there is none
  // The plan's beads at collision::growingPitch(); null: not at hand.
  std::shared_ptr<const collision::GrowingPart> grown = {};
};

// The rims of round feet widen by more than a bead within a layer, bellies close just over the
// plate, roofs just over what is printed: what is laid there hangs a few layers over it. Where a
// stretch that nothing carries (bridges.h) is longer than half of what the process bridges, its
// beads are laid thicker where that is enough (thicken_unsupported.h). Where the plate, or what is printed
// before its patch, is within six of the widest bead's widths beneath it, beads of support as thick
// as layers may be are laid on that under it, along its own curve, before the first path of its
// patch: as narrow as walls six times as high may be, since higher ones tip over. They end a
// fourteenth of its height under it, so that they come off. The nozzle lays them upright; where its
// head would cut into what stands there, as it lays what they carry, or leaning to either side.
// Nothing is laid in what is printed before. Paths keep their order and way, but for what still
// hangs and comes after what it may lean on (orderInsideOut in tilt_unsupported.h). Precondition: one clear
// direction a waypoint. Over bodies and rods: as it was. Throws Cancelled.
RimSupportedPlan addRimSupports(plan::ToolPlan plan, std::vector<Eigen::Vector3d> clearDirection,
                                const platform::PlatformSolid& platform, const robot::Cell& cell,
                                const process::Process& process, const base::RunContext& ctx);

} // namespace voluta::toolpath
