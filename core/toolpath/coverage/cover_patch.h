// Covers a patch with beads.
#pragma once

#include "layers/layer_stack.h"
#include "process/process.h"
#include "toolpath/coverage/bead.h"
#include "toolpath/infill/thin_walls.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

struct PatchCover {
  std::vector<Bead> beads;    // In the order walls from outside inwards, infill, gap fill
  double areaMm2 = 0.0;       // Area of the patch
  double volumeMm3 = 0.0;     // Volume of the patch: area x thickness
  double beadVolumeMm3 = 0.0; // Length of the tip's path x section (mean of each segment's ends)
  double coveredMm2 = 0.0, overlapMm2 = 0.0; // See coverage.h
  bool simple = false;                       // The patch has one boundary loop
  std::vector<ThinWall> thinWalls;           // Printed wider, or left out (options)
  bool lacksField = false;                   // InfillLines::lacksField
  // Beads of skins over sparse infill, and the place of the first one
  std::size_t overSparse = 0;
  Eigen::Vector3d firstOverSparse = Eigen::Vector3d::Zero();
};

// Covers the patch in three steps:
//   1. Walls at (i + 1/2) hatch from the boundary, infill in the remaining region, and gap fill
//   along the middle of the remaining gaps (walls.h, infill.h, gap_fill.h). A seam to another patch
//   is not a surface of the part: it has no walls, and infill extends up to it.
//   2. Every point of the patch is assigned to its nearest centreline, and centrelines move to the
//   middle of their share (Lloyd), twice. With a single ring, as in a pin, the middle is that of
//   the share's extents (bend_middle.h), if the bead then fills more.
//   3. The centrelines are resampled, and each segment deposits the volume of its share: beads tile
//   the patch and their volume is that of the patch, within the process's limits of bead width
//   (Castelli 2.1.1: section = w h - (1 - pi/4) h2).
//
// Outermost walls get the width that `wallWidthMm` requires at the vertices of the rim
// (supported_walls.h; empty: the usual width) where there is room (outer_walls.h). Wound
// infill ignores it. Preconditions: per-vertex arrays match, thickness > 0, options in range.
// `directionRad`: of straight infill lines, instead of that of the options.
// Throws Cancelled, and Error{Usage} for an unknown infill or a wound infill on a patch without a
// chart.
PatchCover coverPatch(const layers::Patch& patch, const process::Process& process,
                      const ToolpathOptions& options, const base::RunContext& ctx,
                      const std::vector<double>& wallWidthMm = {},
                      std::optional<double> directionRad = std::nullopt);

} // namespace voluta::toolpath
