// The stage: layers in, tool-paths out.
#pragma once

#include "collision/growing_part.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/cell.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

struct ToolpathStatistics { // report.json "toolpath"
  std::size_t paths = 0, waypoints = 0;
  double lengthMm = 0.0, travelMm = 0.0; // of beads; straight from each path's end to the next
  std::size_t starts = 0;                // the extruder starts: once a path
  std::size_t simpleRegions = 0;         // patches with one boundary loop
  double coveredFraction = 0.0, overlapFraction = 0.0; // of the patches' area (coverage.h)
  std::size_t gouges = 0;
  double maxTurnDeg = 0.0, materialMm3 = 0.0;
  double rimSupportMm3 =
      0.0; // of beads under what hangs low (rim_supports.h), in materialMm3 as well
  double layerVolumeMm3 = 0.0; // area x thickness of all patches: what materialMm3 should be
};

struct ToolpathResult {
  plan::ToolPlan plan;
  ToolpathStatistics statistics;
  plan::Findings findings;
  // OrientResult's; null: it is not at hand.
  std::shared_ptr<const collision::GrowingPart> grown;
  struct {
    double toolpath = 0.0, orient = 0.0;
  } seconds;
};

// Beads of all patches in one plan, patches in the stack's order; within one, walls from outside
// inwards, infill, gap fill, each time the nearest next; closed beads start at their point nearest
// to where the last one ended. Directions are the patches' own.
struct Assembled {
  plan::ToolPlan plan;
  std::vector<Eigen::Vector3d> clearDirection; // per waypoint
  double travelMm = 0.0;
};
Assembled assemble(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                   const process::Process& process);

// coverPatch for every patch, assemble, orientDirections. Precondition: process is the cell's.
// Throws Cancelled, Error{Usage}.
// Example:
//   toolpath::ToolpathOptions options;
//   options.platform = plate;
//   const toolpath::ToolpathResult made =
//       toolpath::planToolpaths(stack, cell, process, options, ctx);
ToolpathResult planToolpaths(const layers::LayerStack& stack, const robot::Cell& cell,
                             const process::Process& process, const ToolpathOptions& options,
                             const base::RunContext& ctx);

} // namespace voluta::toolpath
