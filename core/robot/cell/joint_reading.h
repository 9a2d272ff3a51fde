// Conversion between a controller's joint values and those of its kinematic family: opposite sense,
// another zero, or the third axis measured from the base instead of the upper arm (driven by a
// parallelogram).
#pragma once

#include "robot/robot_model.h"

#include <vector>

namespace voluta::robot {

// Joint i of the controller is signs[i] * (the family's joint i) + offsets[i]; if the third is
// coupled, the controller's second is added to its third.
struct JointReading {
  std::vector<double> signs;   // 1 or -1, one per joint
  std::vector<double> offsets; // rad; mm for a sliding joint
  bool thirdIsCoupled = false;
};

class ReadKinematics final : public Kinematics {
public:
  // Preconditions: `arm` is not null; a sign and an offset for each joint; at least three joints if
  // the third is coupled.
  ReadKinematics(std::shared_ptr<const Kinematics> arm, JointReading reading);

  int dof() const override { return arm_->dof(); }
  JointKind kindOf(int joint) const override { return arm_->kindOf(joint); }
  bool tilts() const override { return arm_->tilts(); }
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;

private:
  JointVector asFamily(const JointVector& q) const;

  std::shared_ptr<const Kinematics> arm_;
  JointReading reading_;
};

} // namespace voluta::robot
