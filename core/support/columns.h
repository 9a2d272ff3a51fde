// Paths of thin support columns through the empty cells below a part.
#pragma once

#include "base/run_context.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::support {

// The role of a cell for a column; one entry per cell of the grid.
enum class Cell : std::uint8_t {
  Empty = 0,   // a column may use it
  Part = 1,    // must not be touched except at the foot and the top
  Footing = 2, // part that may carry a column
  Support = 3, // another column, which may be joined
  Plate = 4,   // empty, and on the platform
  Closed = 5   // empty, but no column may use it
};

struct Column {
  Eigen::Vector3i foot = Eigen::Vector3i::Zero(), top = Eigen::Vector3i::Zero(); // cells
  std::vector<std::size_t> cells; // from top to foot, each sharing a face with the one before
  enum class Foot : std::uint8_t { Platform, Part, Support } standsOn = Foot::Platform;
  // Faces of its cells that touch the part, except those at its top and its foot; 0: it breaks off
  // cleanly.
  std::size_t sideFaces = 0;
};

// Returns the cheapest column that ends below one of `carried` (cells of the part) and leads down
// from there, straight or sideways but never up, to the platform, a footing or another column. A
// cell costs 1, a sideways step 2 more, a face that touches the part's side 6, an edge or corner
// near the part 0.5, a foot on the part 8. The column has at most `maxLateralSteps` successive
// sideways steps, so that none of its arms is unsupported over a long distance; if there is no such
// column, any number. Returns nullopt if there is no path. Precondition (Error{Internal}): one
// entry per cell; maxLateralSteps > 0. Throws Cancelled.
std::optional<Column> cheapestColumn(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells,
                                     const std::vector<std::size_t>& carried, int maxLateralSteps,
                                     const base::RunContext& ctx);

} // namespace voluta::support
