// Poses of a tool above a plate, by its tilt and the side it tilts to.
#pragma once

#include "base/units.h"

#include <Eigen/Geometry>

namespace voluta::robot {

// Returns work_T_tool [mm, rad]: the tip at `tip`, the nozzle's z down into the plate and rotated
// by `rotation` about itself; upright if `tilt` is 0, else tilted towards the side of `azimuth`.
inline Eigen::Isometry3d leaningTool(const Eigen::Vector3d& tip, double tilt, double azimuth,
                                     double rotation = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = tip;
  pose.linear() = (Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(base::kPi + tilt, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rotation, Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  return pose;
}

} // namespace voluta::robot
