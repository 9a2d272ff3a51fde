// Whether cells contain a part, found without the voxeliser's code: points on its facets, and
// points whose side follows from the parity of rays in odd directions.
#pragma once

#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <cstddef>

namespace voluta::test {

struct Containment {
  std::size_t surface = 0, surfaceOutside = 0; // points of the facets; in no solid cell
  double deepestMm = 0.0;                      // of those: how far from the nearest solid cell
  std::size_t inside = 0, insideOutside = 0;   // points inside by parity; in no solid cell
  std::size_t far = 0,
              farInCells = 0; // outside, a cell's diagonal off the surface; in a solid cell
};

// `samples` points on the facets by area, and as many in the box about the part. A point counts as
// inside where the rays in three directions all cross the facets an odd number of times.
// Precondition: a closed mesh without overlapping shells.
Containment checkContainment(const geometry::TriangleMesh& mesh, const voxel::SolidVoxels& voxels,
                             std::size_t samples, unsigned seed);

} // namespace voluta::test
