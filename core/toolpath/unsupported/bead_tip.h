// Position of the nozzle tip while a bead is printed.
#pragma once

#include <Eigen/Core>

namespace voluta::toolpath {

// `Point`: any bead point with middle and height [mm] and unit direction; a template, so that the
// modules that create beads and those that query them need not depend on each other.
template <typename Point> Eigen::Vector3d tipOf(const Point& p) {
  return p.middle + 0.5 * p.heightMm * p.direction;
}

} // namespace voluta::toolpath
