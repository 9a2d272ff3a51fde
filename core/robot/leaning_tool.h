// Poses of a tool over a plate, by how far it leans and to which side.
#pragma once

#include "base/units.h"

#include <Eigen/Geometry>

namespace voluta::robot {

// work_T_tool, mm and rad: the tip there, the nozzle's z down into the plate and turned by `turn`
// about itself; upright where `tilt` is 0, else it comes from the side of `azimuth`.
inline Eigen::Isometry3d leaningTool(const Eigen::Vector3d& tip, double tilt, double azimuth,
                                     double turn = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = tip;
  pose.linear() = (Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(base::kPi + tilt, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  return pose;
}

} // namespace voluta::robot
