// Whether the head can print the layers of several items layer by layer, before tool-paths cover
// them.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/job_stage.h"
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

// Finds the item that the other items hinder most. A place of a layer is hindered if the head meets
// the layers printed before it in the order of `joined`, however it is tilted, and would clear the
// item's own layers. Returns nullopt if no item is hindered in more than plan::kBlockingShare of
// its layers, in particular if no layer is tilted. Samples the layers, a bead width apart.
// `joined`: of all items, in print order. Throws Cancelled.
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
