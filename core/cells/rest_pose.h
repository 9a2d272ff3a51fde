// Where an arm rests in a cell: the nozzle upright above the plate, clear of everything, away from
// joints' limits and from where the arm is singular.
#pragma once

#include "process/process.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::cells {

struct RestPose {
  robot::JointVector q;  // the cell's, on whole tenths of a degree
  double clearMm = 0.0;  // up to kRestClearMm
  double heightMm = 0.0; // of the tip above the plate
  // Of the arm's derivatives, lengths in units of its reach: the least share of a joint's step that
  // moves the flange. 0: singular.
  double fromSingular = 0.0;
};

inline constexpr double kRestClearMm = 20.0;

// The tip 180 mm above the plate, or as high as the arm gets, clear; of what is clear by
// kRestClearMm, 10 degrees from limits and well away from singular the pose that turns least from
// the joints' zero, else the best in all three together. Nothing: the arm does not get above the
// plate. `reachMm`: of the arm.
std::optional<RestPose> restPose(const robot::Cell& cell, const process::Process& process,
                                 double reachMm);

} // namespace voluta::cells
