// The tool-path stage: turns layers into tool-paths.
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
  // of beads; straight-line distances between consecutive paths
  double lengthMm = 0.0, travelMm = 0.0;
  std::size_t starts = 0;                              // extruder starts, one per path
  std::size_t simpleRegions = 0;                       // patches with one boundary loop
  double coveredFraction = 0.0, overlapFraction = 0.0; // of the patches' area (coverage.h)
  std::size_t gouges = 0;
  double maxTurnDeg = 0.0, materialMm3 = 0.0;
  double rimSupportMm3 =
      0.0; // of support beads under low rims (rim_supports.h), included in materialMm3
  double layerVolumeMm3 = 0.0; // area x thickness of all patches: the target of materialMm3
};

struct ToolpathResult {
  plan::ToolPlan plan;
  ToolpathStatistics statistics;
  plan::Findings findings;
  // From OrientResult; null: not available.
  std::shared_ptr<const collision::GrowingPart> grown;
  struct {
    double toolpath = 0.0, orient = 0.0;
  } seconds;
};

// The beads of all patches in one plan, in the stack's order of patches. Within a patch: walls from
// outside inwards, infill, gap fill, in nearest-neighbour order; closed beads start at their point
// nearest to the end of the last bead. Directions are those of the patches.
struct Assembled {
  plan::ToolPlan plan;
  std::vector<Eigen::Vector3d> clearDirection; // per waypoint
  double travelMm = 0.0;
};
Assembled assemble(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                   const process::Process& process);

// Runs coverPatch for every patch, assemble and orientDirections. Precondition: process is the
// cell's. Throws Cancelled, Error{Usage}. Example:
//   toolpath::ToolpathOptions options;
//   options.platform = plate;
//   const toolpath::ToolpathResult made =
//       toolpath::planToolpaths(stack, cell, process, options, ctx);
ToolpathResult planToolpaths(const layers::LayerStack& stack, const robot::Cell& cell,
                             const process::Process& process, const ToolpathOptions& options,
                             const base::RunContext& ctx);

} // namespace voluta::toolpath
