// A surface in regions of like thickness.
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
// skeletonisation using the shape diameter function, 2008): the diameters, one a triangle, become
// `clusters` normal distributions (0: as many as bestMixture finds), each triangle leans to some of
// them, and a graph cut over neighbours settles where they end, best in concave edges. Regions are
// what hangs together of one cluster; those of less than 1 % of the surface go to the neighbour
// with the longest common border. Precondition (Error{Internal}): a diameter a triangle.
SurfaceRegions surfaceRegions(const geometry::TriangleMesh& mesh,
                              const std::vector<double>& diameters, std::size_t clusters);

} // namespace voluta::planar
