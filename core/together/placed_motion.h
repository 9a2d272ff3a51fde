// The motion of one of the machines that work in one cell: each is planned alone, in its own cell,
// and placed in a frame that all share.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

namespace voluta::collision {
class CellCollision;
class GrowingPart;
} // namespace voluta::collision
namespace voluta::plan {
struct ToolPlan;
struct Trajectory;
} // namespace voluta::plan
namespace voluta::robot {
class Cell;
}

namespace voluta::together {

// Preconditions: none is null; the trajectory is the cell's and prints the plan, or its rest from
// waypoint `printedBefore` on; the part was grown from the plan.
struct PlacedMotion {
  std::shared_ptr<const robot::Cell> cell;
  std::shared_ptr<const collision::CellCollision> collision;
  std::shared_ptr<const plan::ToolPlan> toolPlan;
  std::shared_ptr<const plan::Trajectory> trajectory;
  std::shared_ptr<const collision::GrowingPart> part;
  Eigen::Isometry3d shared_T_world; // of its cell
  std::size_t printedBefore = 0;    // waypoints below it were printed by an earlier run
};

} // namespace voluta::together
