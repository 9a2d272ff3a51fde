// How a cell's external axes stand under the nozzle: behind the arm's joints, in the order in which
// they carry each other. Without any nothing here changes anything. Turns in rad, slides in mm.
#pragma once

#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// The external axes of q, empty where the cell has none; the arm's joints of it.
robot::JointVector axesOf(const robot::Cell& cell, const robot::JointVector& q);
robot::JointVector armOf(const robot::Cell& cell, const robot::JointVector& q);
// q with the external axes at the steps nearest to `axes`.
robot::JointVector withAxes(const robot::Cell& cell, robot::JointVector q,
                            const robot::JointVector& axes);

// What stands in the work frame as it stands with the axes there, seen from the first axis, which
// does not move: a turn, a direction, a point (mm).
Eigen::Quaterniond axesTurn(const robot::Cell& cell, const robot::JointVector& axes);
Eigen::Vector3d turnedByAxes(const robot::Cell& cell, const Eigen::Vector3d& direction,
                             const robot::JointVector& axes);
Eigen::Vector3d movedByAxes(const robot::Cell& cell, const Eigen::Vector3d& point,
                            const robot::JointVector& axes);

// How a point of the base that goes with the platform moves by each external axis: a column each,
// of the point's velocity (mm) and the turn (rad), a rad or mm of the axis (Lynch and Park, Modern
// Robotics, 5.1). At most two axes.
using AxisTwists = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 2>;
AxisTwists axisTwists(const robot::Cell& cell, const robot::JointVector& axes,
                      const Eigen::Vector3d& point);

// Angles of the rod, one a waypoint from `first` on, at which the plan's directions point as nearly
// up in the base as the rod can turn them; each within half a turn of the one before, whatever the
// steps of the axis. The first is that one, by whole turns, from which the axis follows furthest
// inside its limits, and of those the nearest to nearRad. It ends with the last waypoint before
// which the axis does not leave them; empty where it has no room at all. A direction along the
// rod keeps the angle before it. Preconditions: the cell turns a rod; first + count waypoints.
std::vector<double> uprightAngles(const plan::ToolPlan& plan, const robot::Cell& cell,
                                  std::size_t first, std::size_t count, double nearRad);

// Joints of the cell at home, its external axes at rest: where one unwinds, at 0; where it runs on,
// at the whole turn nearest to q's.
robot::JointVector homeAfter(const robot::Cell& cell, const robot::JointVector& q);

} // namespace voluta::motion
