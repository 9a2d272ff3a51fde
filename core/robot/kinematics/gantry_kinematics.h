// Cartesian machine: three slides along the base's x, y and z, in this order from the base, and the
// flange's rotation about z (PPPR). The flange keeps its z parallel to the base's. A machine whose
// round nozzle does not rotate has no motor for the fourth joint: rotating the nozzle changes
// nothing, so its programs leave that joint out.
#pragma once

#include "robot/robot_model.h"

namespace voluta::robot {

class GantryKinematics final : public Kinematics {
public:
  int dof() const override { return 4; }
  JointKind kindOf(int joint) const override {
    return joint < 3 ? JointKind::Sliding : JointKind::Turning;
  }
  bool tilts() const override { return false; }
  // Links 1 to 3 are the slides, at the flange's position along their axes and those before them;
  // link 4 and the flange rotate.
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // One branch; none if the flange's z is tilted by more than kUprightFlangeRad.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;
};

} // namespace voluta::robot
