// The load of a part: what holds it, the forces on it, and the stress between them.
#pragma once

#include "base/run_context.h"
#include "elastic/load_case.h"
#include "elastic/principal_stress.h"
#include "elastic/tension_across.h"
#include "geometry/triangle_mesh.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "project/region.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace voluta::pipeline {

struct ItemLoad {
  elastic::LoadCase cells;
  elastic::PrincipalStress principal; // of the part as one solid
  elastic::TensionAcross tension;     // of it too
};

// Returns whether a region pushes the part.
bool isPushed(std::span<const project::Region> regions);
// Throws Error{Usage} for forces on a part that nothing holds.
void requireHeld(std::span<const project::Region> regions);

// Returns the load of the regions that hold the part or push it; null if there are none. `part`:
// closed; `bodies`: of the regions; all in the work frame. `work_R_file`: turns the axes of the
// part's file. Throws as requireHeld(), elastic::loadCase() and elastic::solved(); Cancelled.
std::shared_ptr<const ItemLoad> itemLoad(const geometry::TriangleMesh& part,
                                         std::span<const project::Region> regions,
                                         std::span<const geometry::TriangleMesh> bodies,
                                         const Eigen::Matrix3d& work_R_file,
                                         const base::RunContext& ctx);

} // namespace voluta::pipeline
