// The way through a URDF's tree from an arm's base to its tip.
#pragma once

#include "robot/kinematics/serial_chain.h"
#include "robot/urdf/urdf_tree.h"

#include <string>
#include <vector>

namespace voluta::robot {

// A link of the description, fixed to the arm's frame `frame` (as Body::frame) at this pose.
struct FixedLink {
  std::size_t link; // index into UrdfTree::links
  int frame;
  Eigen::Isometry3d frame_T_link;
};

struct UrdfChain {
  SerialChain chain;
  std::vector<std::size_t> joints;  // those that turn, indices into UrdfTree::joints
  std::vector<FixedLink> links;     // all that the arm moves or stands on, the turned one first
  std::string base, tip;            // names of links
  std::vector<std::string> leftOut; // names of joints off the way that would move
};

// `tip` and `base` as UrdfOptions. `where` names the file in errors, which are those of readUrdf.
UrdfChain urdfChain(const UrdfTree& tree, const std::string& tip, const std::string& base,
                    const std::string& where);

// The links that may be the flange: those that moving joints lead to and none leaves. Throws as
// above where the tree is none.
std::vector<std::string> urdfTips(const UrdfTree& tree, const std::string& where);

} // namespace voluta::robot
