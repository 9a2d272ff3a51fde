// Share of the part that is inside beads, and volume of beads outside the part.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "replay/depositor.h"
#include "replay/item_finder.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
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

// Shares of cells that are part of the body but narrower than the narrowest bead (thin_cells.h).
struct ThinCells {
  struct Cell {
    std::uint32_t index;
    std::uint8_t share; // at most the part's, in 255ths
  };
  std::vector<Cell> cells;             // ascending by index
  std::vector<std::size_t> firstOfRow; // per row of cells along z, and the end; empty: none is thin
  double volumeMm3 = 0.0;
};

// Distances from the part's surface [mm].
struct SurfaceBands {
  double outsideMm = 0.0; // Farther out, fill is outside the part
  // No farther in, the notches beside the beads' round sides are part of the layered surface: half
  // the height of a layer
  double notchMm = 0.0;
  // Per item: farther in, cells that are not filled are no gaps but sparse infill; empty: the whole
  // part is solid
  std::vector<double> shellMm = {};
};

// Of one item.
struct ItemCoverage {
  // (sum of min(fill, share) + filled notches) / (sum of share - open thin places). The smooth
  // surface of the part cuts through the round sides of the beads: they bulge out of it, and leave
  // notches inside of it that are as large. Notches are cells near the surface inside the rectangle
  // around a bead; the volume that bulges out counts as their fill, as far as it goes.
  double coveredFraction = 0.0;
  // centre of the missing material in the emptiest block of 3 mm
  Eigen::Vector3d worstGap = Eigen::Vector3d::Zero();
  double worstGapMm3 = 0.0;                            // missing volume there
  double thinMm3 = 0.0;                                // open volume in thin places
  Eigen::Vector3d worstThin = Eigen::Vector3d::Zero(); // middle of most of it, in a block of 3 mm
  std::size_t thinPlaces = 0; // separate groups of blocks of 3 mm, seen from above
  double shellMm3 = 0.0;      // volume of the part within SurfaceBands::shellMm of its surface
  double interiorMm3 = 0.0;   // the rest of the part, which coveredFraction leaves out
};

struct Coverage : ItemCoverage { // of all items
  double outsideMm3 = 0.0;       // fill of cells beyond SurfaceBands::outsideMm
  std::vector<ItemCoverage> items;
};

// Supports and skirts are excluded from the fill. Material that is missing in thin places is theirs
// and no gap. Throws Cancelled.
Coverage measureCoverage(const BeadGrid& beads, const PartCells& cells,
                         const geometry::MeshQuery& query, const SurfaceBands& bands,
                         const base::RunContext& ctx, const ItemFinder& items = {},
                         const ThinCells& thin = {});

} // namespace voluta::replay
