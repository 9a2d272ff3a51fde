// A serial arm as its description has it: poses between joints that turn about an axis each. What
// recognises arms and what solves them read it; mm and radians.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::robot {

// A joint's frame is that of the link that it turns.
struct ChainJoint {
  Eigen::Isometry3d link_T_joint = Eigen::Isometry3d::Identity(); // at zero, in the link before it
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();                // a unit, in the joint's frame
};

struct SerialChain {
  std::vector<ChainJoint> joints;
  Eigen::Isometry3d last_T_flange = Eigen::Isometry3d::Identity();
};

// A line in the base's frame: where a joint's axis lies with all joints at zero.
struct AxisLine {
  Eigen::Vector3d point, direction; // direction: a unit
};
std::vector<AxisLine> axesAtZero(const SerialChain& chain);

// As Kinematics::linkPoses and flange. Precondition: as many joints as the chain has.
void chainPoses(const SerialChain& chain, const JointVector& q,
                std::vector<Eigen::Isometry3d>& base_T_link);
Eigen::Isometry3d chainFlange(const SerialChain& chain, const JointVector& q);

// How far a flange is from where it is wanted.
struct PoseError {
  double mm, rad;
};
PoseError poseError(const Eigen::Isometry3d& is, const Eigen::Isometry3d& wanted);

// Newton's steps with the chain's own derivatives, damped by the error itself and at most
// `steps` of them, from q to where the flange is as wanted. Stops at 1e-10 mm and 1e-13 rad. q ends
// at the best that was met, which is what is returned; joints may have left (-pi, pi].
// Precondition: six joints.
PoseError settle(const SerialChain& chain, const Eigen::Isometry3d& base_T_flange, int steps,
                 JointVector& q);

} // namespace voluta::robot
