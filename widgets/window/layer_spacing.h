// Distribution of layer thicknesses, by area.
#pragma once

#include "layers/layer_stack.h"
#include "scene/drawings.h"

#include <vector>

namespace voluta::window {

struct LayerSpacing {
  scene::HeightLimits heights;  // Limits of the process
  double lowMm = 0, highMm = 0; // Range of the bins, slightly beyond the limits
  // Share of the area per bin, lowest first; the outermost bins also contain all values beyond. Sum
  // 1; empty without layers
  std::vector<double> shares;
  double meanMm = 0;               // By area
  double within = 1;               // Share of the area within the limits
  double thinner = 0, thicker = 0; // Shares outside of them
};

// Evaluates each triangle with the mean thickness of its corners. Fills only `heights` if the
// thicknesses are unknown.
LayerSpacing layerSpacing(const layers::LayerStack& stack, const scene::HeightLimits& heights);

} // namespace voluta::window
