// Whether the head can print the layers of several items layer by layer, before tool-paths cover
// them.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/stage.h"
#include "robot/cell.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// An item that cannot be printed layer by layer beside another one.
struct LayerHindrance {
  std::size_t item = 0, neighbour = 0;
  double share = 0.0; // of the item's layers, by area
  // By how much the neighbour has to be moved away [mm]; nullopt: no distance up to 400 mm helps
  std::optional<double> moveMm;
};

// Returns whether a layer tilts the head by more than 3 degrees from upright.
bool tiltsHead(const layers::LayerStack& stack);

// Returns the item of which the largest share of layers, and more than plan::kBlockingShare, cannot
// be printed in the order of `joined` because the head, however it is tilted, meets the printed
// layers of other items, while it would clear the item's own. nullopt if there is none, in
// particular if no layer is tilted. Samples the layers, a bead width apart. `joined`: of all items,
// in print order. Throws Cancelled.
std::optional<LayerHindrance> layerHindrance(const layers::LayerStack& joined,
                                             const robot::Cell& cell,
                                             const process::Process& process,
                                             const base::RunContext& ctx);

// The finding of a hindrance.
struct HindranceStage {
  static constexpr project::Stage kStage = project::Stage::Layers;
  plan::Findings findings; // blocking
};
// `names`: of the items. `hasSequence`: the items could be printed one after another.
HindranceStage hindranceStage(const std::optional<LayerHindrance>& hindrance,
                              const std::vector<std::string>& names, bool hasSequence);

} // namespace voluta::pipeline
