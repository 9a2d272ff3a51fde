// Figures of the regions of a part.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/statistics.h"
#include "project/region.h"

#include <span>
#include <vector>

namespace voluta::regions {

// Returns the figures of each region. `whole`: the layers before their patches were divided, whose
// edges make steps on the part's surface; `stack`: divided. `bodies`: of each region, work frame;
// empty for those with layers of their own and those that cut. Throws Cancelled.
std::vector<plan::RegionStatistics>
figuresOf(const layers::LayerStack& whole, const layers::LayerStack& stack,
          const geometry::TriangleMesh& part, std::span<const project::Region> all,
          std::span<const geometry::TriangleMesh> bodies, const base::RunContext& ctx);

} // namespace voluta::regions
