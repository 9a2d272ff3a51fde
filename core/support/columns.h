// Ways for thin columns of support through the empty cells under a part.
#pragma once

#include "base/run_context.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::support {

// What a cell is to a column; one entry a cell of the grid.
enum class Cell : std::uint8_t {
  Empty = 0,   // a column may take it
  Part = 1,    // not to be touched but at the foot and the top
  Footing = 2, // part that a column may stand on
  Support = 3, // another column, which may be joined
  Plate = 4,   // empty, and stands on the platform
  Closed = 5   // empty, but no column may take it
};

struct Column {
  Eigen::Vector3i foot = Eigen::Vector3i::Zero(), top = Eigen::Vector3i::Zero(); // cells
  std::vector<std::size_t> cells; // from top to foot, each next to the one before by a face
  enum class Foot : std::uint8_t { Platform, Part, Support } standsOn = Foot::Platform;
  // Faces of its cells that touch the part, but for the one under which it ends and the one it
  // stands on: 0 where it breaks off cleanly.
  std::size_t sideFaces = 0;
};

// The cheapest column that ends under one of `carried` (cells of the part) and goes down from
// there, straight or aslant but never up, to the platform, a footing or another column. A cell
// costs 1, a step aside as much as two more, a face that touches the part's side 6, an edge or
// corner near the part half, a foot on the part 8. It goes no more than `mostAside` cells aside
// before the next one down, so that none of its arms is laid over nothing for long; where it would
// not get through like that, any number. None where there is no way.
// Precondition (Error{Internal}): one entry a cell; mostAside > 0. Throws Cancelled.
std::optional<Column> cheapestColumn(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells,
                                     const std::vector<std::size_t>& carried, int mostAside,
                                     const base::RunContext& ctx);

} // namespace voluta::support
