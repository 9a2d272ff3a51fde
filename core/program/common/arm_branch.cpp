#include "program/common/arm_branch.h"

#include <cmath>
#include <vector>

namespace voluta::program {

ArmBranch armBranch(const robot::RobotModel& robot, const robot::JointVector& q) {
  std::vector<Eigen::Isometry3d> links;
  robot.kinematics->linkPoses(q, links);
  const Eigen::Vector3d forward(std::cos(q[0]), std::sin(q[0]), 0.0);
  const Eigen::Vector3d wrist = links[5].translation();
  const Eigen::Vector3d lower = links[3].translation() - links[2].translation();
  const Eigen::Vector3d reach = wrist - links[2].translation();
  return {.behindAxis1 = wrist.dot(forward) < 0.0,
          .behindLowerArm = lower.dot(forward) * reach.z() - lower.z() * reach.dot(forward) > 0.0,
          .axis5Negative = q[4] < 0.0};
}

} // namespace voluta::program
