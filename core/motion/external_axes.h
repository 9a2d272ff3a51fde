// Kinematics of a cell's external axes, which follow the arm's joints in the joint vector, in the
// order in which they carry each other. All functions have no effect in cells without external
// axes. Rotations in rad, slides in mm.
#pragma once

#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Returns the external axes of q; empty if the cell has none.
robot::JointVector axesOf(const robot::Cell& cell, const robot::JointVector& q);
// Returns q with the external axes rounded to the steps nearest to `axes`.
robot::JointVector withAxes(const robot::Cell& cell, robot::JointVector q,
                            const robot::JointVector& axes);

// Return the rotation, a direction and a point [mm] of the work frame as moved by the axes, in the
// fixed frame of the first axis.
Eigen::Quaterniond axesRotation(const robot::Cell& cell, const robot::JointVector& axes);
Eigen::Vector3d turnedByAxes(const robot::Cell& cell, const Eigen::Vector3d& direction,
                             const robot::JointVector& axes);
Eigen::Vector3d movedByAxes(const robot::Cell& cell, const Eigen::Vector3d& point,
                            const robot::JointVector& axes);

// Returns the twist of a point of the base that moves with the platform, one column per external
// axis: velocity [mm] and rotation [rad] per rad or mm of the axis (Lynch and Park, Modern
// Robotics, 5.1). At most two axes.
using AxisTwists = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 2>;
AxisTwists axisTwists(const robot::Cell& cell, const robot::JointVector& axes,
                      const Eigen::Vector3d& point);

// Returns the angles of the rod, one per waypoint from `first` on, at which the plan's directions
// point up in the base as closely as the rod can rotate them. Each is within half a turn of the
// previous one; axis steps are not considered. The first angle is chosen, by whole turns, so that
// the axis stays inside its limits for the most waypoints; of equals, the nearest to nearRad. Ends
// before the first waypoint at which the axis would leave its limits; empty if it has no room at
// all. A direction along the rod keeps the previous angle. Preconditions: the cell rotates a rod;
// the plan has first + count waypoints.
std::vector<double> uprightAngles(const plan::ToolPlan& plan, const robot::Cell& cell,
                                  std::size_t first, std::size_t count, double nearRad);

// Returns the joints of the cell at home with its external axes at rest: at 0 if an axis must
// unwind; at the whole turn nearest to q's if it is continuous.
robot::JointVector homeAfter(const robot::Cell& cell, const robot::JointVector& q);

} // namespace voluta::motion
