#include "robot/nozzle_turns.h"

#include "robot/angles.h"

namespace voluta::robot {

namespace {
constexpr double kSameMm = 1e-7, kSameRad = 1e-10;
}

NozzleTurns::NozzleTurns(const Cell& cell, const Eigen::Isometry3d& work_T_tool, JointVector near)
    : cell_(cell), work_T_tool_(work_T_tool), near_(std::move(near)),
      once_(!cell.robot().kinematics->isFast() && cell.lastJointTurnsNozzle() != 0) {
  if (once_)
    cell.robot().kinematics->inverse(cell.base_T_flange(work_T_tool_, near_), unturned_);
}

void NozzleTurns::at(double rotation, std::vector<JointVector>& solutions) const {
  Eigen::Isometry3d turned = work_T_tool_;
  turned.linear() *= Eigen::AngleAxisd(rotation, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  if (!once_) {
    cell_.inverse(turned, near_, solutions);
    return;
  }
  const Kinematics& arm = *cell_.robot().kinematics;
  const Eigen::Isometry3d base_T_flange = cell_.base_T_flange(turned, near_);
  solutions = unturned_;
  // Descriptions round right angles, so the nozzle may be slightly off the axis.
  const auto missed = [&](JointVector& q) {
    double& last = q[cell_.armDof() - 1];
    last = wrappedAngle(last + cell_.lastJointTurnsNozzle() * rotation);
    const Eigen::Isometry3d flange = arm.flange(q);
    const bool isThere = (flange.translation() - base_T_flange.translation()).norm() < kSameMm &&
                         (flange.linear() - base_T_flange.linear()).norm() < kSameRad;
    if (!isThere && !arm.solveNear(base_T_flange, q))
      return true;
    for (double& angle : q)
      angle = wrappedAngle(angle);
    return false;
  };
  std::erase_if(solutions, missed);
  keepWithinLimits(cell_.robot(), near_, solutions);
  for (JointVector& q : solutions) {
    q.conservativeResize(cell_.dof());
    q.tail(cell_.dof() - cell_.armDof()) = near_.tail(cell_.dof() - cell_.armDof());
  }
}

} // namespace voluta::robot
