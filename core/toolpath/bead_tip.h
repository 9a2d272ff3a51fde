// Where the nozzle's tip is while a bead is laid.
#pragma once

#include "toolpath/cover_patch.h"

namespace voluta::toolpath {

inline Eigen::Vector3d tipOf(const BeadPoint& p) {
  return p.middle + 0.5 * p.heightMm * p.direction;
}

} // namespace voluta::toolpath
