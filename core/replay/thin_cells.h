// The volume of a part in horizontal layers that no bead reaches.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"
#include "replay/bead_coverage.h"
#include "voxel/voxel_grid.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// Returns whether the plan's layers are horizontal: nearly all beads of the part are laid from
// above.
bool hasLevelLayers(const plan::ToolPlan& plan);

// Returns the shares of cells that are narrower than the narrowest bead: sections of the part
// without the places that a disc of that diameter covers where it fits into them (a morphological
// opening). For a corner of angle a and a bead of radius r that is r^2 (1/tan(a/2) - (pi - a)/2) of
// a section. `cells`: of the part on this grid. Sections with open contours have none. Only for
// horizontal layers: where layers curve, each cell would need the section along its own layer.
// Throws Cancelled.
ThinCells thinCells(const geometry::TriangleMesh& part, const PartCells& cells,
                    const voxel::VoxelGrid& grid, double narrowestMm, const base::RunContext& ctx);

} // namespace voluta::replay
