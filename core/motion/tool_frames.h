// The nozzle's orientation along a path before any turn about it, or for good where a rule gives it
// (Castelli 2020, 4.6.2).
#pragma once

#include "motion/motion_options.h"
#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Tool frames in work (z = -direction) at the waypoints [first, first + axes' count, or `count`
// where the cell has no external axes). `axes`: where those are there, else empty. All is laid out
// as it stands in the base of the external axes: round a cone a frame comes back to itself there.
// - Free: carried from waypoint to waypoint by the least turn, to follow on `from`, which is in
//   work with the external axes at fromAxes;
// - Tangent: x along the path, from the waypoint before to the one behind;
// - WorkAxis: x as nearly as can be along the work frame's x with external axes at 0;
// - Rodrigues: the upright tool by the least turn from upright to the direction.
// Where the direction leaves a rule's x open (along it, or at two waypoints in one place) the frame
// before is carried on.
std::vector<Eigen::Quaterniond>
toolFrames(NozzleTurn rule, const plan::ToolPlan& plan, const robot::Cell& cell, std::size_t first,
           std::size_t count, const std::vector<robot::JointVector>& axes,
           const Eigen::Quaterniond& from, const robot::JointVector& fromAxes);

} // namespace voluta::motion
