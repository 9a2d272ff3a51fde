// Inverse of arms with an ortho-parallel base whose axes 4 and 5 meet while axis 6 passes beside
// that point (ABB GoFa, FANUC CRX). Where the flange is given, the meeting point depends on joint 6
// alone: a circle. On it joints 1-3 follow in closed form, four ways; what is left is one equation:
// axis 5 has to stand to axis 4 as it is built. Its roots on the circle are all branches.
#pragma once

#include "robot/kinematics/ortho_base.h"
#include "robot/kinematics/serial_chain.h"

#include <vector>

namespace voluta::robot {

class BentWrist {
public:
  // None: axes 4 and 5 don't meet, or the base is not of that kind. Precondition: six joints.
  static std::optional<BentWrist> of(const SerialChain& chain);

  // Appends all branches, each joint in (-pi, pi]. Roots closer to each other than 1e-9 rad are one
  // branch. Where the meeting point is on axis 1, joint 1 is taken as it is there.
  void inverse(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions) const;

private:
  BentWrist() = default;
  struct Circle;
  struct Sample;
  class Search;

  OrthoBase base_;
  Eigen::Isometry3d flange_T_arm_; // at zero: from the arm's frame to the flange, inverted
  Eigen::Vector3d axis4_, axis5_, axis6_, point6_, wrist_; // at zero, in the arm's frame
  double forearm_ = 0, bend_ = 0, cosBend_ = 1, sinBend_ = 0, cosine45_ = 0;
};

} // namespace voluta::robot
