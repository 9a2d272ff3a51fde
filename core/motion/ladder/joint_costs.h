// Costs of joint poses in the ladder graph, equivalent to radians of joint motion.
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::motion {

// Returns the cost of being near a joint limit, which rises from four fifths of the joint's range.
// Only joints with an entry in `limits` count.
double limitCost(const robot::JointVector& q, const std::vector<robot::JointLimits>& limits);

// Returns the cost of the arm's travel from one path's end to the next one's start: unwinding a
// joint by whole turns is fast with the nozzle lifted, but another IK branch means a long travel
// through the cell. `limits`: of the arm; `from` and `to` may have more joints.
double startCost(const robot::JointVector& from, const robot::JointVector& to,
                 const std::vector<robot::JointLimits>& limits);

} // namespace voluta::motion
