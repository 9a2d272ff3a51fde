// Where on the plate a part is best reached.
#pragma once

#include "cells/reach_map.h"

#include <Eigen/Core>

namespace voluta::cells {

// A part as far as reach is concerned: a cylinder that stands on the plate, and how far the nozzle
// may have to tilt for it.
struct Standing {
  double radiusMm = 0.0, heightMm = 0.0; // > 0
  double tiltRad = 0.0;
};

struct Place {
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); // of the cylinder's axis, work frame, mm
  // Of the poses within the cylinder: of all, and of those upright.
  double share = 0.0, uprightShare = 0.0;
  bool onPlate = false; // all of its foot
  // Nothing of it is out of reach, upright at least, and it stands on the plate.
  bool good() const { return onPlate && uprightShare == 1.0; }
};

// The cylinder standing there. Poses within it: those of the map's points not further from its axis
// than its radius, at the least the nearest point; heights and tilts as ReachMap::share().
Place placeAt(const ReachMap& map, const Standing& part, const Eigen::Vector2d& at);

// Of all points of the map as axes the best: on the plate before beside it, then most of the
// upright poses, then most of all, then nearest to the plate's middle (to 1e-9; then the first).
// Precondition: the map has points.
Place bestPlace(const ReachMap& map, const Standing& part);

} // namespace voluta::cells
