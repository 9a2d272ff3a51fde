// Time between a bead and the bead that covers it, by the clock of the run.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::replay {

// Upper ends of the classes of the histogram [s]; the last class has none.
inline constexpr std::array kLayerTimeClassesS = {5.0,  10.0, 15.0,  20.0,  30.0,  45.0,
                                                  60.0, 90.0, 120.0, 180.0, 300.0, 600.0};

// Figures over all beads of the part that cover another one.
struct LayerTimeFigures {
  double shortestS = 0.0, meanS = 0.0, longestS = 0.0; // the mean is weighted by length
  std::vector<double> lengthMm;                        // per class: length of the covering beads
};

} // namespace voluta::replay
