// A grid of times at which cells are filled, and distances of shapes from the cells filled in time.
#pragma once

#include "base/zeroed_array.h"
#include "collision/shape_distance.h"
#include "robot/body.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::collision {

class FillTimes {
public:
  static constexpr std::uint32_t kNever = 0xffffffffu;

  FillTimes() = default;
  // For each cell, how long before kNever it is filled; 0: it stays empty, and takes no memory.
  using ReversedTimes = base::ZeroedArray<std::uint32_t>;
  static constexpr std::uint32_t leadOf(std::uint32_t moment) { return kNever - moment; }

  // Throws Cancelled.
  FillTimes(const voxel::VoxelGrid& grid, ReversedTimes leads, const base::RunContext& ctx);

  const voxel::VoxelGrid& grid() const { return grid_; }
  std::uint32_t filledAt(std::size_t cell) const { return kNever - leads_[cell]; }

  // Returns whether the point is in a cell that is filled at a time < `before`.
  bool holds(const Eigen::Vector3d& point, std::uint32_t before) const;

  // Returns whether the shape, placed by work_T_shape and grown by `marginMm` (negative shrinks),
  // contains the centre of a cell filled at a time < `before`. Exact for cell centres; the pyramid
  // of minimum times is used for pruning only, and so is the highest row filled in time: a shape
  // above it touches nothing.
  bool touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double marginMm,
               std::uint32_t before) const;

  // The same for a solid of revolution.
  bool touches(const Revolved& solid, const Eigen::Isometry3d& work_T_solid, double marginMm,
               std::uint32_t before) const;

  // Returns the distance from the shape to the nearest centre of a cell filled before `before`,
  // capped at `capMm`; 0 inside. mm.
  double distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double capMm,
                  std::uint32_t before) const;

private:
  // Returns the minimum time in a block of the pyramid (level 0: a cell); kNever outside the grid.
  std::uint32_t earliestAt(int level, const Eigen::Vector3i& block) const;
  // touches() for a solid with that signed distance, whose lowest point is at lowestMm.
  template <typename Distance>
  bool touches(const Distance& signedDistance, double lowestMm, double marginMm,
               std::uint32_t before) const;
  // Returns the height of the highest centre of a cell filled before `before`; a height below the
  // grid if there is none.
  double topBefore(std::uint32_t before) const;

  voxel::VoxelGrid grid_;
  ReversedTimes leads_;
  std::vector<std::uint32_t> fromUp_; // per z: minimum time at this height or above
  struct Level {
    Eigen::Vector3i size;
    ReversedTimes maximum; // per block of 2^level cells: that of the cell filled first
  };
  std::vector<Level> pyramid_;
};

} // namespace voluta::collision
