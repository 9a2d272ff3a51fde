// What joints cost a way through the ladder, in rad of way.
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::motion {

// Of being near a joint's limit, rising from four fifths of its range; of the joints that have
// limits here.
double limitCost(const robot::JointVector& q, const std::vector<robot::JointLimits>& limits);

// Of the arm's going from one path's end to the next one's start: turning a joint back by whole
// turns is done quickly with the nozzle lifted, another branch is a long way through the cell.
// `limits`: of the arm, which `from` and `to` may be longer than.
double startCost(const robot::JointVector& from, const robot::JointVector& to,
                 const std::vector<robot::JointLimits>& limits);

} // namespace voluta::motion
