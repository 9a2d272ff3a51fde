#include "cells/obstacle_file.h"

#include "base/error.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/measures.h"
#include "robot/urdf/solid_pieces.h"

namespace voluta::cells {

ObstacleSolids obstacleOfFile(const std::filesystem::path& file, double mmPerUnit,
                              const base::RunContext& ctx) {
  constexpr int kMaxPieces = 16;
  base::require(mmPerUnit > 0.0, "a unit has a length");
  geometry::TriangleMesh mesh = geometry::readMeshOf(file, geometry::ForeignFrame::Upright).mesh;
  if (!geometry::isForeign(file)) // which states its unit
    for (Eigen::Vector3d& p : mesh.vertices)
      p *= mmPerUnit;
  const double longest = geometry::bounds(mesh).sizes().maxCoeff();
  if (!(longest > 0.0))
    throw base::Error(base::ErrorCode::UnusableInput, "the whole mesh is a single point"_text,
                      file.string());
  return {robot::solidPieces(mesh, kMaxPieces, ctx), longest};
}

} // namespace voluta::cells
