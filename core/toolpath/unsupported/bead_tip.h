// Where the nozzle's tip is while a bead is laid.
#pragma once

#include <Eigen/Core>

namespace voluta::toolpath {

// Of a point of a bead: middle and height in mm, direction unit. Any such point, so that who lays
// beads out and who asks need not know of each other.
template <typename Point> Eigen::Vector3d tipOf(const Point& p) {
  return p.middle + 0.5 * p.heightMm * p.direction;
}

} // namespace voluta::toolpath
