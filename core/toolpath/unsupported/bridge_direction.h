// The directions of infill lines that bridge the gaps below level patches.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// The infill lines of a layer: their direction on the first one, its rotation per layer, and the
// beads around them.
struct UsualLines {
  double angleDeg = 0.0, rotationDeg = 0.0;
  int walls = 0;
};

// Returns for each level one of the patches the direction [rad, from x towards y] of straight lines
// in its infill that leaves least of their length without a hold: a line that crosses a gap of the
// layer below in `whole`, and ends on it on both sides, is held, and better by a shorter gap; where
// a line ends in the air it is not held at all. nullopt for patches that are not level, without a
// layer below or a gap wider than a bead, and where the usual direction is as good. `processOf`: of
// a patch; thread-safe. Precondition: `whole` has these patches, or larger ones. Throws Cancelled.
std::vector<std::optional<double>>
bridgeDirections(std::span<const layers::Patch* const> patches, const layers::LayerStack& whole,
                 const std::function<process::Process(std::size_t)>& processOf,
                 const UsualLines& usual, const base::RunContext& ctx);

} // namespace voluta::toolpath
