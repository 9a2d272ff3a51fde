// The tool-path stage: turns layers into tool-paths.
#pragma once

#include "plan/finding.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "toolpath/cover_rules.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::layers {
struct LayerStack;
class SupportRules;
} // namespace voluta::layers
namespace voluta::robot {
class Cell;
}

namespace voluta::toolpath {

class SeamPlaces;

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

// Layers of one item, and how they are covered. Of the options of several items, those of the
// first hold for the whole job where they concern more than one item: order, prime, brim, rim
// supports.
struct ItemLayers {
  std::shared_ptr<const layers::LayerStack> stack;
  std::vector<CoverRules> rules;                // by Patch::region, those of the item first
  std::shared_ptr<const SeamPlaces> seams = {}; // of the regions; null: none
  // Of the regions; null: none of them blocks supports.
  std::shared_ptr<const layers::SupportRules> blockers = {};
  ToolpathOptions& options() { return rules.front().options; }
  const ToolpathOptions& options() const { return rules.front().options; }
};

// Covers the layers of each item by its own options; then as planToolpaths() below for `joined`,
// which has the patches of all items in print order (layers::joinStacks()). Precondition: one item
// or more. Throws Error{Usage} if one of several items is a spiral. An item without layers gets no
// paths. `others`: places [mm] that the prime keeps clear of, beside the paths of several items.
ToolpathResult planToolpaths(std::span<const ItemLayers> items, const layers::LayerStack& joined,
                             const robot::Cell& cell, const process::Tooling& tooling,
                             const base::RunContext& ctx,
                             std::span<const Eigen::Vector3d> others = {});

// Plans one item without regions: runs coverPatch for every patch, assemble and orientDirections.
// Precondition: the process of the first tool is the cell's. Throws Cancelled, Error{Usage}.
// Example:
//   toolpath::ToolpathOptions options;
//   options.platform = plate;
//   const toolpath::ToolpathResult made =
//       toolpath::planToolpaths(stack, cell, tooling, options, ctx);
ToolpathResult planToolpaths(const layers::LayerStack& stack, const robot::Cell& cell,
                             const process::Tooling& tooling, const ToolpathOptions& options,
                             const base::RunContext& ctx);

} // namespace voluta::toolpath
