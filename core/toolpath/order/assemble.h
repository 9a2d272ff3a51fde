// Puts the beads of all patches into one plan, in print order.
#pragma once

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/order/place_seams.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::toolpath {

struct OrderOptions {
  std::string seam = "nearest"; // id in seamKinds()
  // Whether islands of one flat layer are printed in the order of least travel (islands.h).
  bool orderIslands = true;
  // Whether islands of a flat layer are printed in the order of those below them, so that each has
  // cooled for about as long as the others.
  bool keepIslandOrder = false;
  SeamsOfItems seamsOfRegions = {};
};

// The beads of all patches in one plan, in the stack's order of patches, islands aside. Within a
// patch: the outermost wall, infill, gap fill, then the other walls from inside outwards, each in
// the order of least travel (travel.h); closed walls begin at their seams (seam.h). Directions are
// those of the patches, speeds those of the patches' tools.
struct Assembled {
  plan::ToolPlan plan;
  std::vector<Eigen::Vector3d> clearDirection; // per waypoint
  double travelMm = 0.0;
};
Assembled assemble(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                   const process::Tooling& tooling, const OrderOptions& options = {});

} // namespace voluta::toolpath
