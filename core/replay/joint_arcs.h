// The nozzle's way in the plan's joint motions, for programs that can only go straight: they say it
// in pieces.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::replay {

class JointArcs {
public:
  // Both must outlive the object. Precondition: trajectory.dof == cell.dof().
  // `directions`: do they count? Not of programs that tell none.
  JointArcs(const plan::Trajectory& trajectory, const robot::Cell& cell, bool directions = true)
      : trajectory_(trajectory), cell_(cell), directions_(directions) {}

  // Does the joint motion to that point bring the nozzle there (work frame, mm; unit, -tool z), to
  // 0.25 mm and 0.02 rad? False where the plan does not go by joints.
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
