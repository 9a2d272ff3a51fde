// The order of patches: that of the stack, except for islands of one flat layer.
#pragma once

#include "layers/layer_stack.h"

#include <cstddef>
#include <vector>

namespace voluta::toolpath {

// Consecutive patches [first, end) of the stack that may be printed in any order.
struct IslandRun {
  std::size_t first = 0, end = 0;
  bool operator==(const IslandRun&) const = default;
};

// Returns the runs; together they contain every patch once, in the stack's order. Patches of one
// run have the same layer, item, group and tool, and one plane as mid-surface: none rests on
// another.
std::vector<IslandRun> islandRuns(const layers::LayerStack& stack);

// Returns orders of the stack's patches worth trying for short travel, none or more: indices of the
// patches, the runs in the stack's order.
std::vector<std::vector<std::size_t>> islandOrders(const layers::LayerStack& stack);

// Returns the order of the stack's patches in which the islands of a run follow each other as those
// nearest to them in the run before. Islands are then covered after about equal times.
std::vector<std::size_t> orderAsBelow(const layers::LayerStack& stack);

} // namespace voluta::toolpath
