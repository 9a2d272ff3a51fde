// Scales lengths that were tuned on beads of one width to beads of other widths.
#pragma once

#include "process/process.h"

namespace voluta::toolpath {

// Returns the scale for the process's beads; 1 for beads of 1.2 mm.
inline double beadScaleOf(const process::Process& process) {
  return process.beadWidthMm / 1.2;
}

} // namespace voluta::toolpath
