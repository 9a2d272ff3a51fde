#include "robot/cell/joint_reading.h"

#include "base/error.h"
#include "robot/angles.h"

namespace voluta::robot {

ReadKinematics::ReadKinematics(std::shared_ptr<const Kinematics> arm, JointReading reading)
    : arm_(std::move(arm)), reading_(std::move(reading)) {
  base::require(arm_ != nullptr, "an arm whose joints are read");
  const auto dof = static_cast<std::size_t>(arm_->dof());
  base::require(reading_.signs.size() == dof && reading_.offsets.size() == dof,
                "a sign and an offset a joint");
  base::require(!reading_.thirdIsCoupled || dof >= 3, "a third joint to be coupled");
}

JointVector ReadKinematics::asFamily(const JointVector& q) const {
  base::require(q.size() >= dof(), "as many joints as the arm has");
  JointVector joints = q.head(dof());
  if (reading_.thirdIsCoupled)
    joints[2] -= joints[1];
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    joints[i] = reading_.signs[at] * (joints[i] - reading_.offsets[at]);
  }
  return joints;
}

void ReadKinematics::linkPoses(const JointVector& q,
                               std::vector<Eigen::Isometry3d>& base_T_link) const {
  arm_->linkPoses(asFamily(q), base_T_link);
}

Eigen::Isometry3d ReadKinematics::flange(const JointVector& q) const {
  return arm_->flange(asFamily(q));
}

void ReadKinematics::inverse(const Eigen::Isometry3d& base_T_flange,
                             std::vector<JointVector>& solutions) const {
  const std::size_t before = solutions.size();
  arm_->inverse(base_T_flange, solutions);
  for (std::size_t s = before; s < solutions.size(); ++s) {
    JointVector& q = solutions[s];
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      q[i] = reading_.signs[at] * q[i] + reading_.offsets[at];
      if (arm_->kindOf(static_cast<int>(i)) == JointKind::Turning)
        q[i] = wrappedAngle(q[i]);
    }
    if (reading_.thirdIsCoupled)
      q[2] = wrappedAngle(q[2] + q[1]);
  }
}

} // namespace voluta::robot
