// Print order of a part's regions.
#pragma once

#include "planar/pieces.h"
#include "planar/published/region_planes.h"
#include "planar/published/surface_regions.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::planar {

// RoboFDM, phase II: regions are nodes, stretches of borders between them are edges.
struct PieceGraph {
  int root = 0;
  std::vector<int> order; // of regions: the root, those on the plate, then outwards
  // each plane seen from the region that comes first, in that order
  std::vector<RegionPlane> outwards;
};

// Orders regions breadth first. The root is the region nearest to `root` [mm], otherwise the one
// with the largest contact area with the plate of `whole`, the part that the regions belong to. The
// plate stays below the part, so that the root is printed along z; the other regions on the plate
// come right after the root and are printed from the plate too. `mesh` is the mesh that the regions
// refer to; its resolution may differ from that of `whole`. Throws Error{UnusableInput} if the
// region at `root` is not on the plate.
PieceGraph pieceGraph(const geometry::TriangleMesh& mesh, const SurfaceRegions& regions,
                      const std::vector<RegionPlane>& planes, const Piece& whole,
                      const RiskRule& rule, const std::optional<Eigen::Vector3d>& root);

} // namespace voluta::planar
