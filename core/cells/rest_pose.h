// Search for an arm's home pose in a cell: the nozzle upright above the plate, without collisions,
// away from joint limits and singularities.
#pragma once

#include "process/process.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::cells {

struct RestPose {
  robot::JointVector q;  // the cell's, rounded to tenths of a degree
  double clearMm = 0.0;  // up to kRestClearMm
  double heightMm = 0.0; // of the tip above the plate
  // Smallest singular value of the arm's Jacobian, with lengths in units of its reach. 0: singular.
  double fromSingular = 0.0;
};

inline constexpr double kRestClearMm = 20.0;

// Searches with the tip 180 mm above the plate, or as high as the arm reaches without collision.
// Among poses with a clearance of kRestClearMm, 10 degrees from limits and far from singularities,
// returns the one with the smallest joint values; otherwise the best in all three criteria
// together. Returns nullopt if the arm does not reach above the plate. `reachMm`: of the arm.
std::optional<RestPose> restPose(const robot::Cell& cell, const process::Process& process,
                                 double reachMm);

} // namespace voluta::cells
