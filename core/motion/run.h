// A stretch of a path that is printed without lifting, in joints.
#pragma once

#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// Where the nozzle is and how the arm stands. Tip and tool orientation in the work frame.
struct RobotState {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); // mm
  Eigen::Quaterniond tool = Eigen::Quaterniond::Identity();
  robot::JointVector q;
  robot::JointVector axes = {}; // where external ones would be without steps; q holds the nearest

  Eigen::Vector3d direction() const { return -(tool * Eigen::Vector3d::UnitZ()); }
};

struct RunPoint {
  RobotState at;
  std::size_t waypoint = plan::kNoWaypoint; // none where a step was divided
  std::size_t next = 0;                     // the waypoint that it is, or that it is on the way to
  double volumeMm3 = 0.0;                   // laid on the way from the point before
  double speedMmPerS = 0.0;                 // wanted on the way from the point before
};

struct Run {
  std::size_t path = 0;         // index in ToolPlan::paths
  std::vector<RunPoint> points; // the first is arrived at without printing
  // The joints of each with the turns that the ladder gave, for the statistics.
  std::vector<robot::JointVector> ladder;
};

} // namespace voluta::motion
