// Search for the place on the plate where a part is reached best.
#pragma once

#include "cells/reach_map.h"

#include <Eigen/Core>

namespace voluta::cells {

// A part simplified for reach: a cylinder on the plate, and the largest tilt of the nozzle it may
// need.
struct Standing {
  double radiusMm = 0.0, heightMm = 0.0; // > 0
  double tiltRad = 0.0;
};

struct Place {
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); // of the cylinder's axis, work frame [mm]
  // Reached shares of the poses within the cylinder: of all, and of the upright ones.
  double share = 0.0, uprightShare = 0.0;
  bool onPlate = false; // its whole foot
  // Returns whether all its upright poses are reached and it is on the plate.
  bool good() const { return onPlate && uprightShare == 1.0; }
};

// Rates the cylinder at this position. Its poses: those at the map's points within its radius of
// the axis, at least at the nearest point; heights and tilts as in ReachMap::share().
Place placeAt(const ReachMap& map, const Standing& part, const Eigen::Vector2d& at);

// Shares that differ by less are equal: they are shown in percent.
inline constexpr double kSameShare = 0.005;
// Returns whether `a` is better than `b` by more than kSameShare: on the plate before off it, then
// the upright share, then the share of all poses.
bool isBetter(const Place& a, const Place& b);

// Returns the best of all positions at points of the map: on the plate before off it; of these,
// those whose upright share is within kSameShare of the largest (1 if that is 1); of these, those
// whose share of all poses is so; of these, the nearest to the plate's middle (to 1e-9; then the
// first). Precondition: the map has points.
Place bestPlace(const ReachMap& map, const Standing& part);

} // namespace voluta::cells
