// What drops from the nozzle of a cell.
#pragma once

#include "geometry/drop.h"
#include "robot/cell.h"

namespace voluta::robot {

// Returns whether a drop from the nozzle, with these joints, meets a box of the work frame. The
// base is upright.
inline bool dropMeets(const Cell& cell, const JointVector& q, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d down = cell.base_T_work(q).linear().transpose() * -Eigen::Vector3d::UnitZ();
  return geometry::dropMeets(cell.work_T_tool(q).translation(), down, box);
}

} // namespace voluta::robot
