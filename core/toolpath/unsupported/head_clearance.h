// Does the head, at a waypoint, reach into what is printed or into the plate?
#pragma once

#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>

namespace voluta::toolpath {

// By the same queries as the motion planner's, so that neither refuses what the other took.
class HeadClearance {
public:
  // `cell` must outlive this; process is the cell's.
  HeadClearance(const robot::Cell& cell, const process::Process& process);

  // With the tip at `tip` and the nozzle coming from `direction` (unit): is the head, less the
  // contact tolerance, clear of the plate and what carries it, and by marginMm of all that is
  // filled before waypoint `before` (what lies in it by less than half a cell of the part's grid
  // does not count)? Is the head's holder as far from both as from any body? Work frame, mm.
  bool clears(const collision::GrowingPart& part, const Eigen::Vector3d& tip,
              const Eigen::Vector3d& direction, std::size_t before, double marginMm = 0.0) const;

private:
  collision::CellCollision collision_;
};

} // namespace voluta::toolpath
