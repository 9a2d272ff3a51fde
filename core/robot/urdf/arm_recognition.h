// Which solver an arm of six turning axes gets, told from where its axes lie at zero.
#pragma once

#include "robot/kinematics/serial_chain.h"

#include <functional>

namespace voluta::robot {

enum class ArmKind {
  SphericalWrist, // ortho-parallel base, axes 4-6 through one point:
                  // robot/kinematics/opw_kinematics.h
  ParallelAxes,   // axes 2-4 parallel, each of 4-6 meets the next: robot/kinematics/ur_kinematics.h
  BentWrist,      // ortho-parallel base, axes 4 and 5 meet, 6 beside: robot/kinematics/bent_wrist.h
  Other           // robot/kinematics/numeric_inverse.h
};

struct RecognisedArm {
  ArmKind kind = ArmKind::Other;
  // Appends branches in the chain's own joints, as Kinematics::inverse does. Where the axes are at
  // right angles only nearly (robot/kinematics/ortho_base.h says how nearly), so are the branches'
  // poses.
  std::function<void(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions)>
      inverse;
};

// Precondition: six joints.
RecognisedArm recognisedArm(const SerialChain& chain);

} // namespace voluta::robot
