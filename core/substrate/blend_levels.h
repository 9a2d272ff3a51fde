// Layers that lead from a surface to another one.
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
  double endHeightMm = 0.0;                       // the end surface is the plane at this height,
  std::shared_ptr<const geometry::MeshQuery> end; // or a mesh where there is one
};

// Mid-surfaces on the rays from the ground's points along its normals to the end surface, which
// each ray's length is divided by evenly: thickness varies over a layer. As many layers as bring
// their mean thickness nearest to the wanted one within the limits. Rays that pass the part by, or
// see nothing of the end surface, have no layers. `box`: of the part and a little more. Throws
// Error{UnusableInput}: nothing of it does; no number of layers is within the limits for all that
// does; rays cross before the end, so that layers would fold; Cancelled. (Castelli 2020, 5.2.3, for
// any surfaces.)
std::vector<layers::LevelSurface> blendLevels(const GroundDistance& ground,
                                              const geometry::MeshQuery& part,
                                              const Eigen::AlignedBox3d& box,
                                              const BlendOptions& options,
                                              const base::RunContext& ctx);

} // namespace voluta::substrate
