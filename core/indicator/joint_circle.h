// Joints as points whose straight distance is the step between them: a turning joint is a point of
// the unit circle, so that whole turns change nothing, a sliding one a coordinate of its own.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::indicator {

// How many coordinates such a point has.
Eigen::Index circleSize(const std::vector<robot::JointLimits>& limits);
// q: as many joints as there are limits. Small steps have the length of their turns, rad (sliding
// joints by robot::asTurn); half a turn has length 2.
Eigen::VectorXd onCircle(const robot::JointVector& q,
                         const std::vector<robot::JointLimits>& limits);
// Joints half way from a to b, turning ones the shorter way round, within (-pi, pi].
robot::JointVector halfWay(const robot::JointVector& a, const robot::JointVector& b,
                           const std::vector<robot::JointLimits>& limits);

} // namespace voluta::indicator
