// IK branches of one nozzle pose for rotations about the nozzle. If the nozzle is on the axis of
// the last joint, and the arm's inverse is slow, one inverse serves for all rotations.
#pragma once

#include "robot/cell.h"

#include <vector>

namespace voluta::robot {

class NozzleTurns {
public:
  // `cell` must outlive this object. `near` as in Cell::inverse.
  NozzleTurns(const Cell& cell, const Eigen::Isometry3d& work_T_tool, JointVector near);

  // As Cell::inverse of work_T_tool rotated by `rotation` [rad] about the tool's z.
  void at(double rotation, std::vector<JointVector>& solutions) const;

private:
  const Cell& cell_;
  Eigen::Isometry3d work_T_tool_;
  JointVector near_;
  bool once_;
  std::vector<JointVector> unturned_; // Of the arm alone, each joint in (-pi, pi]
};

} // namespace voluta::robot
