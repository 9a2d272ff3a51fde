// A part of a path printed without lifting, in joint space.
#pragma once

#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Nozzle pose and joints. Tip and tool orientation are in the work frame.
struct RobotState {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); // [mm]
  Eigen::Quaterniond tool = Eigen::Quaterniond::Identity();
  robot::JointVector q;
  // Positions of external axes without their steps; q has the nearest step
  robot::JointVector axes = {};

  Eigen::Vector3d direction() const { return -(tool * Eigen::Vector3d::UnitZ()); }
};

struct RunPoint {
  RobotState at;
  std::size_t waypoint = plan::kNoWaypoint; // None where a step was divided
  std::size_t next = 0;                     // This point's waypoint, or the next one
  double volumeMm3 = 0.0;                   // Deposited since the previous point
  double speedMmPerS = 0.0;                 // Desired speed from the previous point
};

struct Run {
  std::size_t path = 0;         // Index in ToolPlan::paths
  std::vector<RunPoint> points; // The first point is reached without printing
  // The joints per point with the rotations chosen by the ladder, for the statistics.
  std::vector<robot::JointVector> ladder;
};

} // namespace voluta::motion
