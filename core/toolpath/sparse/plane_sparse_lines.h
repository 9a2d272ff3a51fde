// Lines of sparse infill in a plane layer.
#pragma once

#include "base/run_context.h"
#include "process/process.h"
#include "toolpath/options.h"
#include "toolpath/plane/plane_patch.h"
#include "toolpath/sparse/sparse_lines.h"

#include <vector>

namespace voluta::toolpath {

// As sparseBeads(), of a pattern that does not follow the walls, for the part `area` of a plane
// layer. `above`: the sparse parts of the layers above, the nearest first, as many as Branches have
// layers or as there are without a gap.
std::vector<Bead> planeSparseBeads(const PlanePatch& plane, const ClipperLib::Paths& area,
                                   const PatternFrame& frame,
                                   const std::vector<ClipperLib::Paths>& above,
                                   const process::Process& process, const ToolpathOptions& options,
                                   const base::RunContext& ctx);

} // namespace voluta::toolpath
