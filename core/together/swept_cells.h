// The space that a machine's bodies pass through in a segment, as cells of a grid that both
// machines share: two segments whose cells differ do not meet, whatever the speeds.
#pragma once

#include "collision/shape_distance.h"
#include "robot/body.h"
#include "together/placed_motion.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::together {

// Cells, 64 in a word; ascending, without empty words.
using SweptCells = std::vector<std::pair<std::uint32_t, std::uint64_t>>;

// Returns a cell that both contain; nullopt if there is none.
std::optional<std::size_t> commonCell(const SweptCells& a, const SweptCells& b);

// A shape that the motion moves: that of a body, or a box around a part that the arm carries.
struct MovedShape {
  int frame = 0;
  robot::Shape shape;
  collision::Ball ball; // in the frame
};
std::vector<MovedShape> movedShapes(const PlacedMotion& machine);

// Returns a box around the shapes in all poses of the motion; shared frame [mm].
Eigen::AlignedBox3d boxOf(const PlacedMotion& machine, const std::vector<MovedShape>& shapes);

// A pose is kept until a body's points move by this [mm].
inline constexpr double kSweepStepMm = 2.0;

// Marks cells whose centre is closer than reachMm to a shape. Reused from segment to segment, so
// that memory is allocated once.
class Sweeper {
public:
  // `machine` and `shapes` have to outlive it. Precondition: the grid has cells.
  Sweeper(const PlacedMotion& machine, const std::vector<MovedShape>& shapes,
          const voxel::VoxelGrid& grid, double clearanceMm);

  // Returns the cells of points [first, last] of the motion.
  SweptCells sweep(std::size_t first, std::size_t last);

private:
  void mark(const collision::PlacedShape& shape, const Eigen::AlignedBox3d& box);

  const PlacedMotion& machine_;
  const std::vector<MovedShape>& shapes_;
  const voxel::VoxelGrid& grid_;
  double reachMm_;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> used_; // words that are not empty
};

} // namespace voluta::together
