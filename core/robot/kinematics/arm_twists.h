// How an arm's flange goes with its joints, for any kinematic family: each joint turns or slides
// its link as a screw that stands fast in the link before (Lynch and Park, Modern Robotics, 5.1),
// so that two poses of the links tell it exactly, coupled joints included.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::robot {

// A column a joint: velocity of the flange's origin (mm), turn of the flange (rad), both in the
// base's frame, a rad or mm of the joint.
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 8>;

class ArmTwists {
public:
  // `kinematics` outlives it.
  explicit ArmTwists(const Kinematics& kinematics);

  // Also tells the flange's pose. `links` is memory for the call. Of q only the arm's joints are
  // read.
  ArmJacobian jacobian(const JointVector& q, Eigen::Isometry3d& base_T_flange,
                       std::vector<Eigen::Isometry3d>& links) const;

  // Newton's steps from q to the nearest joints that bring the flange there, within 1e-8 mm and
  // 1e-10 rad; without regard to limits. False, and q is of no use, where eight steps do not come
  // there or a step is longer than `longestStep` (rad, sliding joints by asTurn). Ends with the
  // Jacobian before the last step, which is no longer than 3e-6. Joints of q behind the arm's stay.
  bool follow(const Eigen::Isometry3d& base_T_flange, double longestStep, JointVector& q,
              ArmJacobian& jacobian, std::vector<Eigen::Isometry3d>& links) const;

  // Which side of the arm's singular poses q is on: the sign of the Jacobian's determinant (Lynch
  // and Park, Modern Robotics, 5.3). Joints that go steadily from one side to the other pass
  // through a singular pose; a nozzle that passes beside it takes them elsewhere. 0: as good as
  // singular itself, or the arm has not six joints, of which this tells nothing. `links` as above.
  int singularSide(const JointVector& q, std::vector<Eigen::Isometry3d>& links) const;

private:
  struct Twist { // of a link by a joint, in the link's frame
    std::size_t link;
    Eigen::Index joint;
    Eigen::Vector3d velocity, turn;
  };
  const Kinematics& kinematics_;
  std::vector<Twist> twists_;
};

// The joints' velocities at which the flange goes with `twist` (a column of an ArmJacobian), least
// squares, damped by so little that only a singular arm notices. `lengthMm` > 0: what a rad counts
// beside mm.
JointVector jointsFor(const ArmJacobian& jacobian, const Eigen::Matrix<double, 6, 1>& twist,
                      double lengthMm);
// The same for up to five twists, a column each.
using ArmTwistSet = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 5>;
using JointRates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 8, 5>;
JointRates jointsFor(const ArmJacobian& jacobian, const ArmTwistSet& twists, double lengthMm);

} // namespace voluta::robot
