// An external axis of a cell. A cell's external axes are a chain as seen from the robot's base: the
// first is in the base, each next one on the moving side of the one before it, and the platform on
// the last. An axis that carries the robot (a rail, a lift) moves the world, and everything after
// it in the chain, the opposite way; so it comes before all that carry the platform, starting with
// the one next to the robot.
#pragma once

#include "base/json_node.h"
#include "robot/body.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace voluta::robot {

struct ExternalAxis {
  std::string name;
  JointLimits limits;
  double step = 0.0;         // positions are whole multiples of this, rad or mm; 0: any
  bool runsOn = false;       // turns endlessly: limits.min and max are then those of its counter
  bool carriesRobot = false; // false: it carries the platform
  // Its pose at 0 in the moving frame of the axis before it (the first: in the base). It turns
  // about its own x, or slides along it.
  Eigen::Isometry3d before_T_axis = Eigen::Isometry3d::Identity();
  // The frame, in the axis' own, in which carried bodies are given. Both differ by a rotation; if
  // the axis carries the robot, bodies are given in the base as it is with the axis at 0.
  Eigen::Isometry3d axis_T_moved = Eigen::Isometry3d::Identity();
};

// Returns the motion of the axis' frame from its pose at 0 for `value` [rad or mm].
Eigen::Isometry3d movedBy(const ExternalAxis& axis, double value);

// An external axis as in the cell's file; `bodies`: the bodies attached to it.
struct AxisDescription {
  ExternalAxis axis;
  // The cell fills in their frames. Bodies of an axis that carries the robot move with its
  // predecessor in the chain and are given in that frame.
  std::vector<Body> bodies;
};
// The keys are described in robot/cell/cell_reader.cpp. `before`: the axis before it; nullptr:
// none. Throws Error{UnusableInput}.
AxisDescription readExternalAxis(const base::JsonNode& node, const ExternalAxis* before);

} // namespace voluta::robot
