#include "robot/kinematics/gantry_kinematics.h"

#include "base/error.h"
#include "robot/angles.h"

#include <cmath>

namespace voluta::robot {

using Eigen::Isometry3d;
using Eigen::Vector3d;

void GantryKinematics::linkPoses(const JointVector& q, std::vector<Isometry3d>& base_T_link) const {
  base::require(q.size() >= 4, "a gantry has four joints");
  base_T_link.assign(6, Isometry3d::Identity());
  for (Eigen::Index i = 1; i <= 3; ++i)
    base_T_link[static_cast<std::size_t>(i)].translation().head(i) = q.head(i);
  base_T_link[4] = base_T_link[5] = flange(q);
}

Isometry3d GantryKinematics::flange(const JointVector& q) const {
  base::require(q.size() >= 4, "a gantry has four joints");
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = q.head<3>();
  pose.linear() = Eigen::AngleAxisd(q[3], Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

void GantryKinematics::inverse(const Isometry3d& base_T_flange,
                               std::vector<JointVector>& solutions) const {
  const auto& r = base_T_flange.linear();
  if (r(2, 2) <= 0.0 || std::hypot(r(0, 2), r(1, 2)) > kUprightFlangeRad)
    return;
  JointVector q(4);
  q << base_T_flange.translation(), wrappedAngle(std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1)));
  solutions.push_back(q);
}

} // namespace voluta::robot
