// Chooses the solver for an arm of six turning axes from the positions of its axes at zero.
#pragma once

#include "robot/kinematics/serial_chain.h"

#include <functional>

namespace voluta::robot {

enum class ArmKind {
  // Ortho-parallel base, axes 4-6 through one point: robot/kinematics/opw_kinematics.h
  SphericalWrist,
  // Axes 2-4 parallel, each of 4-6 intersects the next: robot/kinematics/ur_kinematics.h
  ParallelAxes,
  // Ortho-parallel base, axes 4 and 5 intersect, 6 is offset: robot/kinematics/bent_wrist.h
  BentWrist,
  Other // See robot/kinematics/numeric_inverse.h
};

struct RecognisedArm {
  ArmKind kind = ArmKind::Other;
  // Appends branches in the chain's own joints, as Kinematics::inverse does. If the axes are only
  // nearly perpendicular (robot/kinematics/ortho_base.h defines the tolerance), the poses of the
  // branches are approximate as well.
  std::function<void(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions)>
      inverse;
};

// Precondition: six joints.
RecognisedArm recognisedArm(const SerialChain& chain);

} // namespace voluta::robot
