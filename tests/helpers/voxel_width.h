// The voxel width at which a part has a wanted number of voxels: for tools that compare by number.
#pragma once

#include "geometry/measures.h"
#include "geometry/triangle_mesh.h"
#include "voxel/solid_voxels.h"

#include <cmath>

namespace voluta::test {

// mm; a few in a thousand off. wanted > 0.
inline double voxelWidthFor(const geometry::TriangleMesh& mesh, double wanted,
                            const base::RunContext& ctx) {
  double width = std::cbrt(std::abs(geometry::volume(mesh)) / wanted);
  for (int i = 0; i < 4; ++i)
    width *= std::cbrt(static_cast<double>(voxel::solidVoxels(mesh, width, ctx).count) / wanted);
  return width;
}

} // namespace voluta::test
