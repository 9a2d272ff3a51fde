// A serial arm as given by its description: poses between joints that each rotate about an axis.
// Used to recognise arms and to solve their kinematics; mm and radians.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::robot {

// A joint's frame is that of the link that it moves.
struct ChainJoint {
  Eigen::Isometry3d link_T_joint = Eigen::Isometry3d::Identity(); // At zero, in the previous link
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); // Unit vector, in the joint's frame
};

struct SerialChain {
  std::vector<ChainJoint> joints;
  Eigen::Isometry3d last_T_flange = Eigen::Isometry3d::Identity();
};

// A line in the base frame: a joint's axis with all joints at zero.
struct AxisLine {
  Eigen::Vector3d point, direction; // Direction: a unit vector
};
std::vector<AxisLine> axesAtZero(const SerialChain& chain);

// As Kinematics::linkPoses and flange. Precondition: as many joints as the chain has.
void chainPoses(const SerialChain& chain, const JointVector& q,
                std::vector<Eigen::Isometry3d>& base_T_link);
Eigen::Isometry3d chainFlange(const SerialChain& chain, const JointVector& q);

// Distance of a flange pose from the requested one.
struct PoseError {
  double mm, rad;
};
PoseError poseError(const Eigen::Isometry3d& is, const Eigen::Isometry3d& wanted);

// At most `steps` Newton steps with the chain's own derivatives, damped by the error itself, from q
// to the requested flange pose. Stops at 1e-10 mm and 1e-13 rad. q becomes the best joints found,
// whose error is returned; they may be outside (-pi, pi]. Precondition: six joints.
PoseError settle(const SerialChain& chain, const Eigen::Isometry3d& base_T_flange, int steps,
                 JointVector& q);

} // namespace voluta::robot
