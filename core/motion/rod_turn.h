// How a rod turns under the nozzle: the external axis of a cell that has one, behind the arm's
// joints. Without one nothing here changes anything.
#pragma once

#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <cstddef>
#include <vector>

namespace voluta::motion {

// The rod's joint in q, rad; 0 where the cell turns none.
double rodAngle(const robot::Cell& cell, const robot::JointVector& q);
// q with the rod at the step nearest to angleRad.
robot::JointVector withRod(const robot::Cell& cell, robot::JointVector q, double angleRad);
// The arm's joints of q.
robot::JointVector armOf(const robot::Cell& cell, const robot::JointVector& q);
// v, of the work frame, as it stands in the base where the rod is at angleRad, but for the work
// frame's own pose there.
Eigen::Vector3d turnedByRod(const Eigen::Vector3d& v, double angleRad);

// Angles of the rod, one a waypoint from `first` on, at which the plan's directions point as nearly
// up in the base as the rod can turn them; each within half a turn of the one before, whatever the
// steps of the axis. The first is that one, by whole turns, from which the axis follows furthest
// inside its limits, and of those the nearest to nearRad. It ends with the last waypoint before
// which the axis does not leave them; empty where it has no room at all. A direction along the
// rod keeps the angle before it. Preconditions: the cell turns a rod; first + count waypoints.
std::vector<double> uprightAngles(const plan::ToolPlan& plan, const robot::Cell& cell,
                                  std::size_t first, std::size_t count, double nearRad);

// Joints of the cell at home, the rod at rest: where its axis unwinds, at 0; where it runs on, at
// the whole turn nearest to q's.
robot::JointVector homeAfter(const robot::Cell& cell, const robot::JointVector& q);

} // namespace voluta::motion
