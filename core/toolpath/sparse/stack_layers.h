// The layers above and below each place of a stack.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "toolpath/plane/plane_levels.h"
#include "toolpath/sparse/layer_count.h"

#include <optional>

namespace voluta::toolpath {

// Thread-safe after construction.
struct StackLayers {
  PlaneLevels levels;
  std::optional<LayerCount> count; // nullopt: all layers are even planes

  // `always`: count layers of planes too. `stack` must outlive this object. Throws Cancelled.
  StackLayers(const layers::LayerStack& stack, bool always, const base::RunContext& ctx);
};

} // namespace voluta::toolpath
