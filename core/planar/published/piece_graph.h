// In which order the regions of a part are printed.
#pragma once

#include "planar/pieces.h"
#include "planar/published/region_planes.h"
#include "planar/published/surface_regions.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::planar {

// RoboFDM, phase II: regions are nodes, stretches of border edges.
struct PieceGraph {
  int root = 0;
  std::vector<int> order; // of regions: the root, what stands on the plate, then outwards
  std::vector<RegionPlane> outwards; // each from the region that comes first, in that order
};

// The region of least distance to `root` (mm), else the one with most of what `whole`, the part
// that the regions are of, has on the plate; then breadth first. The plate stays where it is under
// the part, so the root is printed along z, and the other regions that stand on the plate are
// printed from it too: they come right after the root. `mesh` is what the regions are of, as fine
// as `whole` or not. Throws Error{UnusableInput} where the region at `root` does not stand on the
// plate.
PieceGraph pieceGraph(const geometry::TriangleMesh& mesh, const SurfaceRegions& regions,
                      const std::vector<RegionPlane>& planes, const Piece& whole,
                      const RiskRule& rule, const std::optional<Eigen::Vector3d>& root);

} // namespace voluta::planar
