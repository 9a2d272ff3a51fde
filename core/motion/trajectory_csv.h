// The file trajectory.csv of the debug output (docs/design.md, Command line).
#pragma once

#include "plan/trajectory.h"
#include "robot/kinematics/joint_kind.h"

#include <string>
#include <vector>

namespace voluta::motion {

// Returns one row per point below a header row: timeS, q1Deg ... qNDeg (q3Mm for a sliding joint;
// joints beyond those of `kinds` are revolute), extrudedMm3, extrudedMm (length of filament of the
// given diameter), waypoint (-1 for none), move (print, linear, joint). Precondition:
// filamentDiameterMm > 0.
std::string trajectoryCsv(const plan::Trajectory& trajectory,
                          const std::vector<robot::JointKind>& kinds = {},
                          double filamentDiameterMm = 1.75);

} // namespace voluta::motion
