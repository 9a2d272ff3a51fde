// Support beads under beads that would overhang just above the plate or printed material.
#pragma once

#include "collision/growing_part.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// A plan before its directions are optimised, with the data that assemble() computed per waypoint.
struct RimSupportedPlan {
  plan::ToolPlan plan;
  std::vector<Eigen::Vector3d> clearDirection; // per waypoint
  std::size_t underlaid = 0;                   // number of paths with support beads
  double volumeMm3 = 0.0;                      // of the support beads
  // of the first support bead; undefined if there is none
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
  // The plan's beads at collision::growingPitch(); null: not available.
  std::shared_ptr<const collision::GrowingPart> grown = {};
};

// Rims of round feet widen by more than a bead within a layer, bellies close just above the plate,
// roofs just above printed material: beads there are unsupported, a few layers above the surface
// below. In unsupported stretches (bridges.h) longer than half of the process's bridge length, the
// beads are thickened where that is enough (thicken_unsupported.h). Where the plate, or material
// printed before the patch, is within six times the widest bead's width below, support beads with
// heights in the range of layer heights are printed on it along the bead's own curve, before the
// first path of its patch. They are as narrow as walls six times as high can be, since higher ones
// tip over. They end a fourteenth of the bead's height below it, so that they break off. They are
// printed upright; where the head would collide with printed material, in the direction of the
// beads that they support, or tilted to either side. No support is printed inside earlier material.
// Paths keep their order and direction, except those that remain unsupported and are moved after
// the paths that can support them (orderInsideOut in tilt_unsupported.h). Precondition: one clear
// direction per waypoint. On bodies and rods the plan is returned unchanged. Throws Cancelled.
RimSupportedPlan addRimSupports(plan::ToolPlan plan, std::vector<Eigen::Vector3d> clearDirection,
                                const platform::PlatformSolid& platform, const robot::Cell& cell,
                                const process::Tooling& tooling, const base::RunContext& ctx);

} // namespace voluta::toolpath
