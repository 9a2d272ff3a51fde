// Layers that blend from one surface into another.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "layers/level_surface.h"
#include "substrate/ground_distance.h"
#include "substrate/level_stack.h"

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace voluta::substrate {

struct BlendOptions {
  LevelOptions levels;
  double endHeightMm = 0.0;                       // Height of the plane that is the end surface,
  std::shared_ptr<const geometry::MeshQuery> end; // or the end surface as a mesh, if set
};

// Returns mid-surfaces on the rays from the ground's points along its normals to the end surface.
// Each ray is divided evenly, so the thickness varies over a layer. The number of layers is the one
// within the limits whose mean thickness is nearest to the layer height. Rays that miss the part or
// the end surface have no layers. `box`: the part's bounding box, slightly enlarged. Throws
// Error{UnusableInput} if all rays miss; if no number of layers keeps all thicknesses within the
// limits; if rays cross before the end, so that layers would fold. Throws Cancelled. (Castelli
// 2020, 5.2.3, for any surfaces.)
std::vector<layers::LevelSurface> blendLevels(const GroundDistance& ground,
                                              const geometry::MeshQuery& part,
                                              const Eigen::AlignedBox3d& box,
                                              const BlendOptions& options,
                                              const base::RunContext& ctx);

} // namespace voluta::substrate
