// Any serial arm of six revolute axes, given by the poses and axes of its description: forward
// kinematics exactly as described, inverse by the solver suited to its axes.
#pragma once

#include "robot/urdf/arm_recognition.h"

namespace voluta::robot {

class ChainKinematics final : public Kinematics {
public:
  // Precondition: six joints.
  explicit ChainKinematics(SerialChain chain);

  int dof() const override { return 6; }
  const SerialChain& chain() const { return chain_; }
  ArmKind kind() const { return arm_.kind; }
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // For every ArmKind except Other, appends all branches; for Other, nearly all. Each reaches the
  // pose within 1e-6 mm and 1e-9 rad.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;
  bool isFast() const override { return arm_.kind != ArmKind::Other; }
  bool solveNear(const Eigen::Isometry3d& base_T_flange, JointVector& q) const override;

private:
  SerialChain chain_;
  RecognisedArm arm_;
};

} // namespace voluta::robot
