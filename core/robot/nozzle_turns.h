// The arm at one place of the nozzle, turned about it. Where the nozzle stands on the axis of the
// last joint, and the arm's inverse is not fast, one inverse serves for all turns.
#pragma once

#include "robot/cell.h"

#include <vector>

namespace voluta::robot {

class NozzleTurns {
public:
  // `cell` must outlive this. `near` as Cell::inverse.
  NozzleTurns(const Cell& cell, const Eigen::Isometry3d& work_T_tool, JointVector near);

  // As Cell::inverse of work_T_tool turned by `turn` (rad) about the tool's z.
  void at(double turn, std::vector<JointVector>& solutions) const;

private:
  const Cell& cell_;
  Eigen::Isometry3d work_T_tool_;
  JointVector near_;
  bool once_;
  std::vector<JointVector> unturned_; // of the arm alone, each joint in (-pi, pi]
};

} // namespace voluta::robot
