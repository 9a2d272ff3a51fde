// An axis of a cell beside the robot's own. Those of a cell are a chain as the robot's base sees
// it: the first stands in the base, each next one on what the one before it moves, and the platform
// on the last. An axis that carries the robot (a rail, a lift) moves the world and all that stands
// behind it there the other way, so it comes before all that carry the platform, the one right
// under the robot first.
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
  double step = 0.0;         // it stands at whole multiples of this, rad or mm; 0: anywhere
  bool runsOn = false;       // turns without end: limits.min and max are then those of its counter
  bool carriesRobot = false; // else the platform
  // Where it lies in the frame of the axis before it, which goes with that one (the first: in the
  // base), at 0. It turns about its own x, or slides along it.
  Eigen::Isometry3d before_T_axis = Eigen::Isometry3d::Identity();
  // The frame in which what it moves is given, in its own: they differ by a turn, or for one that
  // carries the robot so that what it moves is given as it stands in the base with it at 0.
  Eigen::Isometry3d axis_T_moved = Eigen::Isometry3d::Identity();
};

// Where it moves its frame to from where it is at 0: `value` rad or mm.
Eigen::Isometry3d movedBy(const ExternalAxis& axis, double value);

// A cell's external axis as its file has it; `bodies` is what it carries by itself.
struct AxisDescription {
  ExternalAxis axis;
  // Their frames are the cell's to fill in. Of one that carries the robot they go with what comes
  // before it in the chain, and are given there.
  std::vector<Body> bodies;
};
// The keys are described in robot/cell/cell_reader.cpp. `before`: the axis before it, nullptr:
// none. Throws Error{UnusableInput}.
AxisDescription readExternalAxis(const base::JsonNode& node, const ExternalAxis* before);

} // namespace voluta::robot
