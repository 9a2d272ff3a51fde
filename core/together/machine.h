// One of the machines that work in one cell: each is planned alone, in its own cell, and placed in
// a frame that all share.
#pragma once

#include <Eigen/Geometry>

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

// References: the caller keeps them alive. Preconditions: the trajectory is the cell's and prints
// the plan; the part was grown from the plan.
struct Machine {
  const robot::Cell& cell;
  const collision::CellCollision& collision;
  const plan::ToolPlan& toolPlan;
  const plan::Trajectory& trajectory;
  const collision::GrowingPart& part;
  Eigen::Isometry3d shared_T_world; // of its cell
};

} // namespace voluta::together
