// How thick layers are, as shares of their area.
#pragma once

#include "layers/layer_stack.h"
#include "scene/drawings.h"

#include <vector>

namespace voluta::window {

struct LayerSpacing {
  scene::HeightLimits heights;  // what the process lays
  double lowMm = 0, highMm = 0; // span of the bins, a little beyond the limits
  std::vector<double> shares;   // of the area, a bin each, lowest first; the outermost hold what is
                                // beyond as well; sum 1, empty where there are no layers
  double meanMm = 0;            // by area
  double within = 1;            // share of the area within the limits
  double thinner = 0, thicker = 0; // and outside of them
};

// Triangle by triangle, with the mean thickness of the corners. Nothing but `heights` is filled
// where they are not known.
LayerSpacing layerSpacing(const layers::LayerStack& stack, const scene::HeightLimits& heights);

} // namespace voluta::window
