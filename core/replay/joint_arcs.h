// The nozzle's path in the plan's joint motions, for programs that can only move straight and
// approximate it in pieces.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::replay {

class JointArcs {
public:
  // Both must outlive the object. Precondition: trajectory.dof == cell.dof(). `directions`: whether
  // directions are compared; false for programs that state none.
  JointArcs(const plan::Trajectory& trajectory, const robot::Cell& cell, bool directions = true)
      : trajectory_(trajectory), cell_(cell), directions_(directions) {}

  // Returns whether the joint motion to this point passes the nozzle pose (work frame, mm; unit,
  // -tool z) within 0.25 mm and 0.02 rad. Returns false if the planned motion is not a joint
  // motion.
  bool passes(std::size_t point, const Eigen::Vector3d& tip, const Eigen::Vector3d& direction);

private:
  void sample(std::size_t point);

  const plan::Trajectory& trajectory_;
  const robot::Cell& cell_;
  bool directions_ = true;
  std::size_t sampled_ = 0; // the point that the samples lead to; 0: none
  std::vector<Eigen::Vector3d> tip_, direction_;
};

} // namespace voluta::replay
