// SCARA: two upright turning axes with a bar behind each, a shaft that slides along the third and
// turns about it (RRPR). The flange, the shaft's lower end, keeps its z on the base's.
// Inverse: two bars in the plane (references on robots, section 2; Craig, Introduction to Robotics,
// 4.4).
#pragma once

#include "robot/robot_model.h"

namespace voluta::robot {

// mm. top: height of the flange above the base's origin where joint 3 is 0; it goes up with
// joint 3.
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
  // Links 1 and 2 turn about their frames' origins, x along their bars, at the base's height; links
  // 3 and 4 are the shaft, their origin the flange's, without and with its turn.
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // Two branches, by the sign of joint 2; where the bars are in line, one. None where the flange's
  // z leans by more than kUprightFlangeRad. Folded on itself, with bars of one length, joint 1 is
  // 0.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;

private:
  ScaraGeometry g_;
};

} // namespace voluta::robot
