// Finds the chain of joints in a URDF's tree from an arm's base to its tip.
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/urdf/urdf_tree.h"

#include <string>
#include <vector>

namespace voluta::robot {

// A link of the description, fixed to the arm's frame `frame` (as Body::frame) at this pose.
struct FixedLink {
  std::size_t link; // Index into UrdfTree::links
  int frame;
  Eigen::Isometry3d frame_T_link;
};

struct UrdfChain {
  SerialChain chain;
  std::vector<std::size_t> joints; // The turning joints, indices into UrdfTree::joints
  std::vector<FixedLink> links; // All links that the arm moves or stands on, the chain's own first
  std::string base, tip;        // Names of links
  std::vector<std::string> leftOut; // Names of movable joints outside the chain
};

// `tip` and `base` as in UrdfOptions. `where` names the file in errors, which are those of
// readUrdf.
UrdfChain urdfChain(const UrdfTree& tree, const std::string& tip, const std::string& base,
                    const std::string& where);

// Returns the links that may be the flange: those that movable joints lead to and none leads on
// from. Throws as above if the links do not form a tree.
std::vector<std::string> urdfTips(const UrdfTree& tree, const std::string& where);

} // namespace voluta::robot
