// The tool-paths of several items as one plan: planned ones, and those that came with files.
#pragma once

#include "layers/print_order.h"
#include "plan/tool_plan.h"

#include <cstddef>
#include <memory>
#include <span>

namespace voluta::pipeline {

// Tool-paths of one item that came with its file.
struct GivenPlan {
  std::size_t item = 0;
  std::shared_ptr<const plan::ToolPlan> plan; // of this item only, whatever its paths name
};

// Returns all paths as one plan. Waste with which `planned` begins comes first. Then items follow
// one after another in `sequence`; or always the lowest layer that is not printed yet, of equal
// heights that of the first item. The paths of each plan keep their order. ToolPath::item is the
// job's item, ToolPath::patch and ToolPath::layer differ between the plans: layers are numbered in
// the order in which they begin, and those of equal height have the same number if they are printed
// by layer. `fill` has an entry for each item. `planned`: of all other items, with the job's items;
// may be empty. Preconditions: no given plan is null; `sequence` has each item of the job once.
plan::ToolPlan joinedPlans(const plan::ToolPlan& planned, std::span<const GivenPlan> given,
                           layers::PrintOrder order, std::span<const std::size_t> sequence);

} // namespace voluta::pipeline
