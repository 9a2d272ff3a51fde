#include "robot/pointing_down.h"

#include "base/error.h"
#include "base/units.h"

#include <Eigen/Geometry>

namespace voluta::robot {

std::vector<JointVector> pointingDownAt(const Cell& cell, const Eigen::Vector3d& tip,
                                        const JointVector& home) {
  base::require(cell.nozzleMount() == Mount::Flange, "a nozzle that moves");
  const Eigen::Isometry3d base_T_work = cell.base_T_work(home);
  const Eigen::Matrix3d atHome = (base_T_work * cell.work_T_tool(home)).linear();
  const Eigen::Matrix3d down =
      Eigen::Quaterniond::FromTwoVectors(atHome.col(2), -Eigen::Vector3d::UnitZ()) * atHome;
  std::vector<JointVector> all, solutions;
  for (int k = 0; k < 4; ++k) {
    Eigen::Isometry3d base_T_tool = Eigen::Isometry3d::Identity();
    base_T_tool.linear() =
        Eigen::AngleAxisd(0.5 * base::kPi * k, Eigen::Vector3d::UnitZ()).toRotationMatrix() * down;
    base_T_tool.translation() = tip;
    cell.inverse(base_T_work.inverse() * base_T_tool, home, solutions);
    all.insert(all.end(), solutions.begin(), solutions.end());
  }
  return all;
}

} // namespace voluta::robot
