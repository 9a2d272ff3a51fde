// trajectory.csv of the debug output (docs/design.md, Command line).
#pragma once

#include "plan/trajectory.h"

#include <string>

namespace voluta::motion {

// One row a point under a header row: timeS, q1Deg ... qNDeg, extrudedMm3, extrudedMm (length of
// filament of the given diameter), waypoint (-1 for none), move (print, linear, joint).
// Precondition: filamentDiameterMm > 0.
std::string trajectoryCsv(const plan::Trajectory& trajectory, double filamentDiameterMm = 1.75);

} // namespace voluta::motion
