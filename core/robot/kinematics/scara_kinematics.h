// SCARA: two upright revolute axes with a bar each, and a shaft that slides along and rotates about
// the third (RRPR). The flange, the shaft's lower end, keeps its z parallel to the base's. Inverse:
// two bars in the plane (references on robots, section 2; Craig, Introduction to Robotics, 4.4).
#pragma once

#include "robot/robot_model.h"

namespace voluta::robot {

// [mm]. top: height of the flange above the base's origin where joint 3 is 0; it rises with joint
// 3.
struct ScaraGeometry {
  double a1, a2, top;
};

class ScaraKinematics final : public Kinematics {
public:
  // Precondition: a1 and a2 above 0.
  explicit ScaraKinematics(const ScaraGeometry& geometry);

  int dof() const override { return 4; }
  JointKind kindOf(int joint) const override {
    return joint == 2 ? JointKind::Sliding : JointKind::Turning;
  }
  bool tilts() const override { return false; }
  // Links 1 and 2 rotate about their frames' origins, x along their bars, at the base's height;
  // links 3 and 4 are the shaft, with the flange's origin, without and with its rotation.
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // Two branches, by the sign of joint 2; one if the bars are in line. None if the flange's z is
  // tilted by more than kUprightFlangeRad. If the arm is folded and both bars have the same length,
  // joint 1 is 0.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;

private:
  ScaraGeometry g_;
};

} // namespace voluta::robot
