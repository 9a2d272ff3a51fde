// Positions of a positioner's two turning axes that turn a direction of the part upright, for a
// machine whose nozzle cannot tilt (a gantry or a SCARA above a tilting and turning table).
#pragma once

#include "robot/cell.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::robot {

// Returns whether the cell tilts the part instead of the nozzle: its arm cannot tilt, and exactly
// two turning external axes carry the platform.
bool tiltsPart(const Cell& cell);

// Directions closer to the second axis than this count as along it, whatever that axis' angle: the
// nozzle is then tilted by as much.
inline constexpr double kAlongAxisRad = 0.002;

struct UprightAxes {
  JointVector axes;        // of the two axes, each in (-pi, pi]
  bool lastIsFree = false; // the second axis may have any angle; it is 0 here
};

// Returns every position of the axes, regardless of limits, at which `direction` (unit, work frame)
// is the base's z, within kAlongAxisRad; empty if there is none. Precondition: tiltsPart(cell).
std::vector<UprightAxes> uprightAxes(const Cell& cell, const Eigen::Vector3d& direction);

} // namespace voluta::robot
