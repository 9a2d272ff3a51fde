// An obstacle of a cell from a mesh's file.
#pragma once

#include "base/run_context.h"
#include "robot/body.h"

#include <filesystem>
#include <vector>

namespace voluta::cells {

struct ObstacleSolids {
  std::vector<robot::Shape> solids;
  double longestMm = 0.0; // of the mesh along an axis
};

// What the file holds as at most 16 solids (robot/urdf/solid_pieces.h), where it was drawn, upright
// where the format says what is up. All formats that a part may come in
// (geometry/formats/mesh_reader.h, foreign_reader.h); `mmPerUnit`: how long a unit is of those that
// do not say. Throws Error{UnreadableFile, UnusableInput} as those; Error{UnusableInput}: all of it
// is one point. Throws Cancelled. Precondition: mmPerUnit > 0.
ObstacleSolids obstacleOfFile(const std::filesystem::path& file, double mmPerUnit,
                              const base::RunContext& ctx);

} // namespace voluta::cells
