// Universal Robots: six axes, axes 2-4 parallel, no spherical wrist. Chain:
// Universal_Robots_ROS2_Description, config/<ur>/default_kinematics.yaml; standard DH with alpha =
// (90, 0, 0, 90, -90, 0) deg. Inverse: Hawkins, "Analytic Inverse Kinematics for the Universal
// Robots UR-5/UR-10 Arms", Georgia Tech 2013, with half of the arc functions replaced by atan2 of
// both legs so that no precision is lost near singular poses.
#pragma once

#include "robot/robot_model.h"

namespace voluta::robot {

// DH lengths [mm]; a2 and a3 are negative for the maker's arms.
struct UrGeometry {
  double d1, a2, a3, d4, d5, d6;
};

class UrKinematics final : public Kinematics {
public:
  // Precondition: a2, a3, d6 not 0.
  explicit UrKinematics(const UrGeometry& geometry);

  int dof() const override { return 6; }
  // The links' frames are those of the maker's URDF (capsules and meshes are given in them), the
  // base that of the controller, the flange tool0 = DH frame 6.
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // Up to 8 branches: shoulder left/right x wrist up/down x elbow up/down. At a singular pose
  // coinciding branches are given once: sin(theta5) = 0 (theta6 is free and taken as 0), elbow
  // stretched or folded, wrist centre at the shoulder's offset.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;

private:
  UrGeometry g_;
};

} // namespace voluta::robot
