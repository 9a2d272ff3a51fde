// The nozzle's orientation along a path, before any turn about its axis, or final if a rule
// determines it (Castelli 2020, 4.6.2).
#pragma once

#include "motion/motion_options.h"
#include "plan/tool_plan.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Returns tool frames in the work frame (z = -direction) at the waypoints [first, first + number of
// axes, or `count` if the cell has no external axes). `axes`: positions of the external axes if
// there are any, else empty. Frames are computed in the base of the external axes: around a cone a
// frame returns to itself there.
// - Free: carried from waypoint to waypoint by the smallest rotation, continuing `from`, which is
//   in the work frame with the external axes at fromAxes;
// - Tangent: x along the path, from the previous waypoint to the next;
// - WorkAxis: x as close as possible to the work frame's x with external axes at 0;
// - Rodrigues: the upright tool rotated by the smallest rotation from upright to the direction.
//
// If the direction leaves a rule's x undetermined (parallel to it, or two waypoints at one
// position), the previous frame is carried on.
std::vector<Eigen::Quaterniond>
toolFrames(NozzleRotation rule, const plan::ToolPlan& plan, const robot::Cell& cell,
           std::size_t first, std::size_t count, const std::vector<robot::JointVector>& axes,
           const Eigen::Quaterniond& from, const robot::JointVector& fromAxes);

} // namespace voluta::motion
