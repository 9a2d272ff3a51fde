// Joints as points whose Euclidean distance is the step between them: a turning joint is a point on
// the unit circle, so that whole turns do not matter, a sliding one a single coordinate.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::indicator {

// Returns the number of coordinates of such a point.
Eigen::Index circleSize(const std::vector<robot::JointLimits>& limits);
// q: one joint per limit. The length of a small step is that of its rotations [rad] (sliding joints
// by robot::asAngle); half a turn has length 2.
Eigen::VectorXd onCircle(const robot::JointVector& q,
                         const std::vector<robot::JointLimits>& limits);
// Returns the joints half way from a to b, turning ones the shorter way round, within (-pi, pi].
robot::JointVector jointMidpoint(const robot::JointVector& a, const robot::JointVector& b,
                                 const std::vector<robot::JointLimits>& limits);

} // namespace voluta::indicator
