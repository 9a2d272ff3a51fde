// Scales lengths that were tuned on beads of one width to beads of other widths.
#pragma once

#include "process/process.h"

#include <algorithm>

namespace voluta::toolpath {

// Returns the scale for the process's beads; 1 for beads of 1.2 mm.
inline double beadScaleOf(const process::Process& process) {
  return process.beadWidthMm / 1.2;
}

// Returns the factor of tolerances and steps [mm] that grow with larger beads and keep their size
// for finer ones, to which they are no obstacle.
inline double largeBeadScaleOf(const process::Process& process) {
  return std::max(1.0, beadScaleOf(process));
}

} // namespace voluta::toolpath
