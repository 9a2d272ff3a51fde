// Walls of plane layers by offsets of their outline.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"
#include "toolpath/coverage/bead.h"
#include "toolpath/options.h"

#include <optional>
#include <vector>

namespace voluta::toolpath {

struct PlaneWalls {
  std::vector<Bead> beads; // from outside inwards
  double bandMm2 = 0.0;    // area that they fill
  // Inside the walls, with a rim of seams; nullopt: nothing
  std::optional<layers::Patch> rest;
};

// Returns the walls of a plane patch whose walls have one width, wherever the layer is wide enough
// for all of them: they lie as those of wallAt(), and their width is such that they fill the area
// outside the rest. Returns nullopt for other patches, for those where walls leave a long gap of
// less than a bead, or one for a bead or two, and if there are no walls. wallWidthMm: as for
// coverPatch().
std::optional<PlaneWalls> planeWalls(const layers::Patch& patch, const process::Process& process,
                                     const ToolpathOptions& options,
                                     const std::vector<double>& wallWidthMm);

} // namespace voluta::toolpath
