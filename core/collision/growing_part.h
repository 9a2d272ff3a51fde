// The part as it grows: one grid of "first filled at waypoint i", good for any moment (DESIGN §3).
#pragma once

#include "plan/tool_plan.h"
#include "robot/body.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::process {
struct Process;
}

namespace voluta::collision {

// Pitch of a grid for the growing part, mm: a quarter of the process's bead width or half its layer
// height, whichever is less, as fine as programs are judged on, but coarser where the plan's box
// would hold more than 2^27 such cells.
double growingPitch(const plan::ToolPlan& plan, const process::Process& process);

class GrowingPart {
public:
  // Deposits every segment of every path: section of process/bead_model.h below the tip, along the
  // waypoints' directions. A cell counts as filled when its centre is inside a bead. Work frame.
  GrowingPart(const plan::ToolPlan& plan, double pitchMm, const base::RunContext& ctx);

  const voxel::VoxelGrid& grid() const { return grid_; }
  // Index of the waypoint at whose arrival the cell is filled; kNeverFilled otherwise.
  static constexpr std::uint32_t kNeverFilled = 0xffffffffu;
  std::uint32_t filledAt(std::size_t cell) const { return filledAt_[cell]; }

  // Does the shape, placed by work_T_shape and grown by `marginMm` (negative shrinks), hold the
  // centre of a cell filled at a waypoint index < `before`? Exact for cell centres; the pyramid of
  // least fill times only prunes.
  bool touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double marginMm,
               std::size_t before) const;

  // Distance from the shape to the nearest centre of a cell filled before `before`, capped at
  // `capMm`; 0 when inside. mm.
  double distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double capMm,
                  std::size_t before) const;

private:
  // Least fill index in a block of the pyramid (level 0: a cell); kNeverFilled outside the grid.
  std::uint32_t leastAt(int level, const Eigen::Vector3i& block) const;

  voxel::VoxelGrid grid_;
  std::vector<std::uint32_t> filledAt_;
  struct Level {
    Eigen::Vector3i size;
    std::vector<std::uint32_t> least; // least fill index in a block of 2^level cells
  };
  std::vector<Level> pyramid_;
};

} // namespace voluta::collision
