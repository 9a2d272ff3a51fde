// Lengths that were found by trial on beads of one width go with the width of others.
#pragma once

#include "process/process.h"

namespace voluta::toolpath {

// Of a process's beads, 1 for those of 1.2 mm.
inline double beadScaleOf(const process::Process& process) {
  return process.beadWidthMm / 1.2;
}

} // namespace voluta::toolpath
