// Partition of a surface into regions of similar thickness.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstddef>
#include <vector>

namespace voluta::planar {

struct SurfaceRegions {
  std::vector<int> ofTriangle; // in [0, count)
  int count = 0;
  std::size_t clusters = 0; // of thickness
};

// RoboFDM, phase I, step 3 (after Shapira, Shamir, Cohen-Or, Consistent mesh partitioning and
// skeletonisation using the shape diameter function, 2008). The diameters, one per triangle, are
// modelled by `clusters` normal distributions (0: as many as bestMixture finds). These give each
// triangle probabilities of belonging to a cluster, and a graph cut over neighbours sets the
// borders, preferably along concave edges. Regions are connected components of one cluster; those
// of less than 1 % of the surface are merged into the neighbour with the longest common border.
// Precondition (Error{Internal}): one diameter per triangle.
SurfaceRegions surfaceRegions(const geometry::TriangleMesh& mesh,
                              const std::vector<double>& diameters, std::size_t clusters);

} // namespace voluta::planar
