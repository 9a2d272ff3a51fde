// Ortho-parallel arms with a spherical wrist: axis 1 upright, axes 2 and 3 parallel and across it,
// axes 4-6 through one point. Parameters and convention: Brandstoetter, Angerer, Hofbaur, "An
// Analytical Solution of the Inverse Kinematics Problem of Industrial Serial Manipulators with an
// Ortho-parallel Basis and a Spherical Wrist", 2014. The inverse is derived in the source file.
#pragma once

#include "robot/robot_model.h"

#include <array>

namespace voluta::robot {

// Lengths [mm]. With all joints at their offsets the arm is upright: the shoulder (axis 2) is at
// (a1, 0, c1), the elbow (axis 3) c2 above it, the wrist's centre (a2, b, c3) from the elbow, the
// flange c4 above that.
struct OpwGeometry {
  double a1, a2, b, c1, c2, c3, c4;
  // [rad]: the controller's joint i is the angle from the upright arm plus offset i.
  std::array<double, 6> offsets{};
};

class OpwKinematics final : public Kinematics {
public:
  // Precondition: c2 > 0, and a2, c3 not both 0.
  explicit OpwKinematics(const OpwGeometry& geometry);

  int dof() const override { return 6; }
  // With all joints at the controller's zero, every link's frame is parallel to the base. Origins:
  // link 1 at (0, 0, c1), 2 on the shoulder, 3 on the elbow, 4 at the foot of the forearm's length
  // c3, 5 at the wrist's centre, 6 on the flange: those of the maker's URDF for the IRB 1200. The
  // flange's z points out of it.
  void linkPoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_link) const override;
  Eigen::Isometry3d flange(const JointVector& q) const override;
  // Up to 8 branches: shoulder front/back x elbow up/down x wrist normal/flipped. At a singular
  // pose coinciding branches are given once: wrist's centre on axis 1 (joint 1 is free), elbow
  // stretched or folded, sin(theta5) = 0 (joint 4 is free). A free joint is at its offset.
  void inverse(const Eigen::Isometry3d& base_T_flange,
               std::vector<JointVector>& solutions) const override;

private:
  struct Turns;
  Turns turnsAt(const JointVector& q) const;

  OpwGeometry g_;
  double forearm_, bend_; // Elbow to wrist's centre: length, angle from c3's axis
  // Rotations of the links at the controller's zero, transposed
  std::array<Eigen::Matrix3d, 6> zeros_;
};

} // namespace voluta::robot
