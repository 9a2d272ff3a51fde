// Refines a patch to the triangles that covering it with beads needs.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"
#include "toolpath/options.h"
#include "toolpath/patch_surface.h"

namespace voluta::toolpath {

// Returns the patch refined to options.edgeMm, coarser far from the boundary if the infill is
// straight there, and finer where fronts from opposite sides of the boundary meet: the distance
// from the boundary has a ridge there, whose height decides whether one or two beads fit, and in
// walls of less than a bead, whether one fits.
PatchSurface refinedPatch(const layers::Patch& patch, const process::Process& process,
                          const ToolpathOptions& options, bool isStraightInside);

} // namespace voluta::toolpath
