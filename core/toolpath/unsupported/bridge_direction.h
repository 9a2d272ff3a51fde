// The direction of infill lines that bridges the gaps below a flat patch.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"

#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Returns the direction [rad, from x towards y] of straight lines in the region `insetMm` inside of
// `patch` that leaves least of their length without a hold: a line that crosses a gap of the layer
// below, and ends on it on both sides, is held, and better by a shorter gap; where a line ends in
// the air it is not held at all. nullopt if `usualRad` is as good, or no gap is wider than a bead.
// Preconditions: `patch` and `below` are flat, at the heights of two layers that follow each other.
std::optional<double> bridgeDirection(const layers::Patch& patch,
                                      std::span<const layers::Patch* const> below,
                                      const process::Process& process, double insetMm,
                                      double usualRad);

// The infill lines of a layer: their direction on the first one, its rotation per layer, and the
// beads around them.
struct UsualLines {
  double angleDeg = 0.0, rotationDeg = 0.0;
  int walls = 0;
};

// Returns bridgeDirection() of each level patch of `stack` over the layer below it in `whole`;
// nullopt for all others. Precondition: `whole` has the patches of `stack`, or larger ones. Throws
// Cancelled.
std::vector<std::optional<double>>
bridgeDirections(const layers::LayerStack& stack, const layers::LayerStack& whole,
                 const std::vector<process::Process>& processOfPatch, const UsualLines& usual,
                 const base::RunContext& ctx);

} // namespace voluta::toolpath
