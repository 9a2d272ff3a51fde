// Reads a robot from its URDF: the chain of six turning axes from its base to its tip, with fixed
// joints folded into the links that they are fixed to, limits, and one or more solids per link.
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/robot_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

struct UrdfOptions {
  // The link whose frame is the flange, with z pointing outwards. Empty: the link that no joint
  // leads on from; of several on the same moving link, "tool0".
  std::string tip;
  // The link whose frame is the base of poses. Empty: "base" if it is fixed to the root (the usual
  // name of the controller's base frame), else the root.
  std::string base;
  std::string id;                 // Empty: the description's name in lower case with dashes
  std::string controller = "csv"; // Id of the program format that its controller reads
};

struct UrdfRobot {
  RobotModel model; // Its neverMeet is empty: cells/arm_import.h computes the pairs
  SerialChain chain;
  std::string base, tip; // Names of the links that were used
  std::string source;    // Origin of the data, for the robot's file
};

// Reads the robot. Data missing in the description is assumed and listed in model.assumed, as are
// solids without a volume and limits of safety controllers, which tighten those of their joints.
// Meshes may be STL, OBJ and other formats of geometry/formats; each is enclosed by capsules. A
// mesh that is missing or unreadable is replaced by a capsule along its link, and listed too.
//
// Throws Error{UnreadableFile} as readUrdfTree, and Error{UnusableInput} naming link or joint: two
// bases, a loop, no tip or several, an unknown name, not exactly six axes, a joint that slides,
// floats, moves in a plane or mimics another, two joints of one name, or limits that leave no room.
UrdfRobot readUrdf(const std::filesystem::path& file, const UrdfOptions& options);

} // namespace voluta::robot
