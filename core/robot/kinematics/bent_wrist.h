// Inverse kinematics of arms with an ortho-parallel base whose axes 4 and 5 intersect while axis 6
// is offset from that point (ABB GoFa, FANUC CRX). For a given flange pose, the intersection
// depends on joint 6 alone: it is on a circle. For each point of it, joints 1-3 follow in closed
// form, in four ways, and one equation remains: the angle between axes 4 and 5 must be as built.
// Its roots on the circle are all branches.
#pragma once

#include "robot/kinematics/ortho_base.h"
#include "robot/kinematics/serial_chain.h"

#include <vector>

namespace voluta::robot {

class BentWrist {
public:
  // Returns nullopt if axes 4 and 5 don't intersect, or the base is not of that kind. Precondition:
  // six joints.
  static std::optional<BentWrist> of(const SerialChain& chain);

  // Appends all branches, each joint in (-pi, pi]. Roots closer than 1e-9 rad count as one branch.
  // If the intersection is on axis 1, joint 1 has the value for which that happens.
  void inverse(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions) const;

private:
  BentWrist() = default;
  struct Circle;
  struct Sample;
  class Search;

  OrthoBase base_;
  Eigen::Isometry3d flange_T_arm_; // At zero: from the arm's frame to the flange, inverted
  Eigen::Vector3d axis4_, axis5_, axis6_, point6_, wrist_; // At zero, in the arm's frame
  double forearm_ = 0, bend_ = 0, cosBend_ = 1, sinBend_ = 0, cosine45_ = 0;
};

} // namespace voluta::robot
