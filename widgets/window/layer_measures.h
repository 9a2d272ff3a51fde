// Measures of all layers for the Layers page, computed once.
#pragma once

#include "layers/layer_stack.h"
#include "panels/layer_info.h"
#include "plan/tool_plan.h"
#include "timeline/clock.h"

#include <vector>

namespace voluta::window {

// Returns one entry per layer, by index. `plan` and `clock` may be null: then lengths, waypoints
// and times are 0. Time: of the printed segments, without travel.
std::vector<panels::LayerMeasures> layerMeasures(const layers::LayerStack& stack,
                                                 const plan::ToolPlan* plan,
                                                 const timeline::Clock* clock);

// Returns the level of each layer's top along the growth: the sum of mean thicknesses [mm].
std::vector<double> layerTopsMm(const std::vector<panels::LayerMeasures>& measures);
// Returns the outer radius [mm] of each layer that is closed around the x axis (layers::Chart with
// a period). Empty if any layer has no such patch.
std::vector<double> layerRadiiMm(const layers::LayerStack& stack);

} // namespace voluta::window
