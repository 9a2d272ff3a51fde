// What the Layers page says of each layer, gathered once for all of them.
#pragma once

#include "layers/layer_stack.h"
#include "panels/layer_info.h"
#include "plan/tool_plan.h"
#include "timeline/clock.h"

#include <vector>

namespace voluta::window {

// One entry a layer, by index. `plan` and `clock` may be null: then lengths, waypoints and times
// are 0. Time: of the segments laid, without travel.
std::vector<panels::LayerMeasures> layerMeasures(const layers::LayerStack& stack,
                                                 const plan::ToolPlan* plan,
                                                 const timeline::Clock* clock);

// Level of each layer's top along the growth: mean thicknesses added up, mm.
std::vector<double> layerTopsMm(const std::vector<panels::LayerMeasures>& measures);
// Of layers that are closed around the x axis (layers::Chart with a period): each one's outer
// radius, mm. Empty where any has no such patch.
std::vector<double> layerRadiiMm(const layers::LayerStack& stack);

} // namespace voluta::window
