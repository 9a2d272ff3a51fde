// Plates of two machines that lie in each other: the same plate described twice, or a wrong place.
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace voluta::robot {
class Cell;
}

namespace voluta::together {

struct PlateOverlap {
  double depthMm = 0.0; // the shortest way along the first plate that parts them
  double areaMm2 = 0.0; // of what they share, seen along that plate's normal
};

struct PlacedCell {
  const robot::Cell& cell;
  Eigen::Isometry3d shared_T_world;
};

// Returns the overlap of two plates at rest, at the middle of the height that they share; nullopt
// if they share less than 0.1 mm of way, one of the cells has none, or a motion moves one.
std::optional<PlateOverlap> plateOverlap(const PlacedCell& one, const PlacedCell& other);

} // namespace voluta::together
