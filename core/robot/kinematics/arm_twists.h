// The differential kinematics of an arm's flange, for any kinematic family: each joint rotates or
// slides its link as a screw that is fixed in the previous link (Lynch and Park, Modern Robotics,
// 5.1), so two poses of the links determine it exactly, coupled joints included.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::robot {

// One column per joint: velocity of the flange's origin [mm] and rotation of the flange [rad], both
// in the base frame, per rad or mm of the joint.
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 8>;

class ArmTwists {
public:
  // `kinematics` must outlive this object.
  explicit ArmTwists(const Kinematics& kinematics);

  // Returns the Jacobian and the flange's pose. `links` is memory for the call. Only the arm's
  // joints of q are read.
  ArmJacobian jacobian(const JointVector& q, Eigen::Isometry3d& base_T_flange,
                       std::vector<Eigen::Isometry3d>& links) const;

  // Newton steps from q to the nearest joints that bring the flange to the pose, within 1e-8 mm and
  // 1e-10 rad, ignoring limits. Returns false, with q invalid, if eight steps do not suffice or a
  // step is longer than `longestStep` (rad, sliding joints by asAngle). `jacobian` is that before
  // the last step, which is at most 3e-6. Joints of q after the arm's are unchanged.
  bool follow(const Eigen::Isometry3d& base_T_flange, double longestStep, JointVector& q,
              ArmJacobian& jacobian, std::vector<Eigen::Isometry3d>& links) const;

  // Returns on which side of the arm's singular poses q is: the sign of the Jacobian's determinant
  // (Lynch and Park, Modern Robotics, 5.3). Joints that move continuously from one side to the
  // other pass through a singular pose; a nozzle that passes beside it leads to another
  // configuration. Returns 0 if q is practically singular, or if the arm does not have six joints.
  // `links` as above.
  int singularSide(const JointVector& q, std::vector<Eigen::Isometry3d>& links) const;

private:
  struct Twist { // Of a link by a joint, in the link's frame
    std::size_t link;
    Eigen::Index joint;
    Eigen::Vector3d velocity, rotation;
  };
  const Kinematics& kinematics_;
  std::vector<Twist> twists_;
};

// Returns the joint velocities at which the flange moves with `twist` (a column of an ArmJacobian):
// least squares, with a damping that only matters near singular poses. `lengthMm` > 0: length that
// makes a radian comparable to mm.
JointVector jointsFor(const ArmJacobian& jacobian, const Eigen::Matrix<double, 6, 1>& twist,
                      double lengthMm);
// The same for up to five twists, one per column.
using ArmTwistSet = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 5>;
using JointRates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 8, 5>;
JointRates jointsFor(const ArmJacobian& jacobian, const ArmTwistSet& twists, double lengthMm);

} // namespace voluta::robot
