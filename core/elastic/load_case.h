// A part as cells, where it is held, and the forces on it.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace voluta::elastic {

// A force [N] that the cells within a body share.
struct BodyForce {
  geometry::TriangleMesh body; // closed
  Eigen::Vector3d newton = Eigen::Vector3d::Zero();
};

struct CellForce {
  std::vector<std::size_t> cells;
  Eigen::Vector3d newton = Eigen::Vector3d::Zero();
};

struct LoadCase {
  voxel::VoxelGrid grid;
  std::vector<float> share;      // per cell, that the part fills, [0, 1]
  std::vector<std::size_t> held; // cells whose nodes do not move
  std::vector<CellForce> forces;

  // Returns whether a cell belongs to the part: it fills more than a sliver of it.
  bool isSolid(std::size_t cell) const { return share[cell] >= kSolidShare; }
  static constexpr float kSolidShare = 0.2F;
};

// Returns the cells of a closed part, about `cells` of them, that are connected with held ones
// through their sides, with the places of holds and forces. All meshes in one frame [mm]. Throws
// Error{Usage} if nothing of the part is within the holds, or nothing that is held is within a
// force; Error{UnusableInput} for a part without volume; Cancelled.
LoadCase loadCase(const geometry::TriangleMesh& part, std::span<const geometry::TriangleMesh> holds,
                  std::span<const BodyForce> forces, std::size_t cells,
                  const base::RunContext& ctx);

} // namespace voluta::elastic
