// Reading of a cell's obstacle from a mesh file.
#pragma once

#include "base/run_context.h"
#include "robot/body.h"

#include <filesystem>
#include <vector>

namespace voluta::cells {

struct ObstacleSolids {
  std::vector<robot::Shape> solids;
  double longestMm = 0.0; // largest extent of the mesh along an axis
};

// Returns the file's content as at most 16 solids (robot/urdf/solid_pieces.h), in the file's
// position, upright if the format defines the up direction. Accepts all formats of parts
// (geometry/formats/mesh_reader.h, foreign_reader.h); `mmPerUnit`: length of a unit for formats
// that do not state it. Throws Error{UnreadableFile, UnusableInput} as those, Error{UnusableInput}
// if the whole mesh is one point, and Cancelled. Precondition: mmPerUnit > 0.
ObstacleSolids obstacleOfFile(const std::filesystem::path& file, double mmPerUnit,
                              const base::RunContext& ctx);

} // namespace voluta::cells
