// A robot from its URDF: the chain of six turning axes from its base to its tip, with fixed joints
// folded into the links that they are fixed to, limits, and a solid or a few for each link.
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/robot_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

struct UrdfOptions {
  // The link whose frame is the flange: z out of it. Empty: the one that no joint leads on from; of
  // several that hang on the same moving link "tool0".
  std::string tip;
  // The link whose frame is the base of poses. Empty: "base" where it is fixed to the root (what
  // descriptions call the frame that the controller counts from), else the root.
  std::string base;
  std::string id;                 // empty: the description's name, in small letters and dashes
  std::string controller = "csv"; // id of the program format that its controller reads
};

struct UrdfRobot {
  RobotModel model; // its neverMeet is empty: cells/arm_import.h finds what it takes
  SerialChain chain;
  std::string base, tip; // names of the links that were taken
  std::string source;    // what it was read from, for the robot's file
};

// What the description does not say is assumed, and told in model.assumed. Meshes are STL, OBJ and
// what else geometry/formats reads, each enclosed by a capsule; one that is missing or of a format
// that is not read is replaced by a capsule along its link, and told there.
//
// Throws Error{UnreadableFile} as readUrdfTree, Error{UnusableInput} that names link or joint: two
// bases, a loop, no tip or several, a name that is not there, another number of axes than six, a
// joint that slides, floats, moves in a plane or follows another, limits in the wrong order.
UrdfRobot readUrdf(const std::filesystem::path& file, const UrdfOptions& options);

} // namespace voluta::robot
