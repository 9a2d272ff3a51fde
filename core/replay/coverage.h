// How much of the part is inside beads, and how much of the beads is outside the part.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "replay/depositor.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// Share of each cell that the part takes, in 255ths.
struct PartCells {
  std::vector<std::uint8_t> share;
  double volumeMm3 = 0.0;
};

// From the crossings of vertical lines, four a column of cells and 36 where these cross the part
// unequally often: exact along z. Between crossings
// the winding decides; where it does not return to nothing (the mesh is open there), the
// generalised winding number does. Throws Cancelled.
PartCells partCells(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                    const voxel::VoxelGrid& grid, const base::RunContext& ctx);

struct Coverage {
  double coveredFraction = 0.0; // sum of min(fill, share) / sum of share
  double outsideMm3 = 0.0;      // fill of cells further than `toleranceMm` outside the part
  Eigen::Vector3d worstGap = Eigen::Vector3d::Zero(); // middle of what the emptiest 3 mm lack
  double worstGapMm3 = 0.0;                           // and how much is missing there
};

// Supports and skirts are left out of the fill. Throws Cancelled.
Coverage measureCoverage(const BeadGrid& beads, const PartCells& cells,
                         const geometry::MeshQuery& query, double toleranceMm,
                         const base::RunContext& ctx);

} // namespace voluta::replay
