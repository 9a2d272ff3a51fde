// Checks whether the head at a waypoint collides with the printed part or the plate.
#pragma once

#include "collision/cell_collision.h"

#include <Eigen/Core>
#include <cstddef>

namespace voluta::collision {
class GrowingPart;
}
namespace voluta::process {
struct Process;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::toolpath {

// Uses the same queries as the motion planner, so that both accept the same poses.
class HeadClearance {
public:
  // `cell` must outlive the object; process is the cell's.
  HeadClearance(const robot::Cell& cell, const process::Process& process);

  // Returns whether the head, with the tip at `tip` and the nozzle along `direction` (unit), is
  // clear: reduced by the contact tolerance, clear of the plate and its carrier, and at least
  // marginMm from all material filled before waypoint `before` (overlaps of less than half a cell
  // of the part's grid do not count). The head's holder has to keep the usual body clearance from
  // both. Work frame, mm.
  bool clears(const collision::GrowingPart& part, const Eigen::Vector3d& tip,
              const Eigen::Vector3d& direction, std::size_t before, double marginMm = 0.0) const;

private:
  collision::CellCollision collision_;
};

} // namespace voluta::toolpath
