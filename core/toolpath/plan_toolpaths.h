// The tool-path stage: turns layers into tool-paths.
#pragma once

#include "collision/growing_part.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/statistics.h"
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

struct ToolpathResult {
  plan::ToolPlan plan;
  plan::ToolpathStatistics statistics;
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
