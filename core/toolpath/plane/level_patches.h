// The level patches of a stack, to find the layer below another one.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "toolpath/plane/plane_patch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// Returns whether a plane is parallel to the plate.
bool isLevel(const PlanePatch& plane);

// Thread-safe after construction.
class LevelPatches {
public:
  // Throws Cancelled.
  LevelPatches(const layers::LayerStack& stack, const base::RunContext& ctx);

  // Returns a patch of the stack; nullptr if it is not level.
  const PlanePatch* patch(std::size_t index) const;
  // Returns the area of the layer that a level one rests on, supports included, at least within its
  // bounding box; empty on the first layer, and where a part begins in the air.
  ClipperLib::Paths below(const PlanePatch& layer) const;

private:
  struct Box {
    ClipperLib::IntPoint low, high;
    bool touches(const Box& other) const;
  };
  static Box boxOf(const PlanePatch& plane);

  std::vector<std::optional<PlanePatch>> planes_;
  std::vector<Box> boxes_; // per patch
  std::vector<std::size_t> byHeight_;
};

} // namespace voluta::toolpath
