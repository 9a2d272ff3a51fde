// Share of the part that is inside beads, and volume of beads outside the part.
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

// Share of each cell that the part occupies, in 255ths.
struct PartCells {
  std::vector<std::uint8_t> share;
  double volumeMm3 = 0.0;
};

// Computes the shares from the crossings of vertical lines, four per column of cells and 36 where
// these cross the part unequally often; exact along z. Between crossings the winding number
// decides; if it does not return to zero (an open mesh), the generalised winding number does.
// Throws Cancelled.
PartCells partCells(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                    const voxel::VoxelGrid& grid, const base::RunContext& ctx);

struct Coverage {
  double coveredFraction = 0.0; // sum of min(fill, share) / sum of share
  double outsideMm3 = 0.0;      // fill of cells further than `toleranceMm` outside the part
  // centre of the missing material in the emptiest block of 3 mm
  Eigen::Vector3d worstGap = Eigen::Vector3d::Zero();
  double worstGapMm3 = 0.0; // missing volume there
};

// Supports and skirts are excluded from the fill. Throws Cancelled.
Coverage measureCoverage(const BeadGrid& beads, const PartCells& cells,
                         const geometry::MeshQuery& query, double toleranceMm,
                         const base::RunContext& ctx);

} // namespace voluta::replay
