// Poses of a moving nozzle that points down.
#pragma once

#include "robot/cell.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::robot {

// Returns the joints that bring the nozzle's tip to a point of the base with the nozzle pointing
// down, in four turns about itself; external axes as at home, joints near to it. The base is
// upright. Precondition: the nozzle is on the flange.
std::vector<JointVector> pointingDownAt(const Cell& cell, const Eigen::Vector3d& tip,
                                        const JointVector& home);

} // namespace voluta::robot
