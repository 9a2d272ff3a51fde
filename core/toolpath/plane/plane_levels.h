// The plane layers of a stack, level by level.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "toolpath/plane/plane_patch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// Items whose layers all lie in planes. Thread-safe after construction.
class PlaneLevels {
public:
  // Throws Cancelled.
  PlaneLevels(const layers::LayerStack& stack, const base::RunContext& ctx);

  // Returns a patch as a polygon; nullptr for supports, and if any patch of its item is not plane.
  const PlanePatch* patch(std::size_t index) const;
  bool isEven(std::size_t index) const { return patches_[index] && patches_[index]->isEven; }

  // The layers of one item and one build direction at one height.
  struct Level {
    std::vector<std::size_t> patches; // of the stack
    double middleMm = 0.0, thicknessMm = 0.0;
  };
  // Returns the levels that follow the patch without a gap, upwards for sign = 1 and downwards for
  // -1, at most `count`, the nearest first. Precondition: patch(index).
  std::vector<const Level*> from(std::size_t index, int sign, int count) const;

  // Returns the outlines of all patches of a level.
  ClipperLib::Paths outline(const Level& level) const;

private:
  std::vector<std::optional<PlanePatch>> patches_;
  std::vector<std::size_t> levelOf_; // per patch
  std::vector<Level> levels_;        // those of one stack of layers follow each other, ascending
  std::vector<std::size_t> stackOf_; // per level
};

} // namespace voluta::toolpath
