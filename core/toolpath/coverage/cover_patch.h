// A patch covered with beads.
#pragma once

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

struct BeadPoint {
  Eigen::Vector3d middle;         // on the patch: the middle of the bead's height, mm
  Eigen::Vector3d direction;      // unit, of the patch
  Eigen::Vector3d clearDirection; // unit, of the patch
  double widthMm = 0.0, heightMm = 0.0;
};
// A closed bead repeats its first point at its end.
struct Bead {
  std::vector<BeadPoint> points;
  plan::PathKind kind = plan::PathKind::Wall;
  int ring = 0; // walls: 0 is the outermost
  bool closed = false;
};

struct PatchCover {
  std::vector<Bead> beads;    // walls from outside inwards, infill, gap fill
  double areaMm2 = 0.0;       // of the patch
  double volumeMm3 = 0.0;     // of the patch: area x thickness
  double beadVolumeMm3 = 0.0; // length of the tip's way x section (mean of each segment's ends)
  double coveredMm2 = 0.0, overlapMm2 = 0.0; // coverage.h
  bool simple = false;                       // the patch has one boundary loop
};

// 1. Walls at (i + 1/2) hatch from the boundary, infill in what they leave, gap fill along the
//    middle of what both leave (walls.h, infill.h, gap_fill.h). A seam to another patch is no
//    surface of the part: it has no walls, infill goes up to it.
// 2. Every point of the patch goes to its nearest centreline; centrelines move to the middle of
//    what they got (Lloyd), twice.
// 3. Resampled; each stretch lays the volume of what is nearest to it: beads tile the patch and
//    their volume is the patch's, as far as the bead's limits of width allow (Castelli 2.1.1:
//    section = w h - (1 - pi/4) h2).
// Outermost walls are as wide as `wallWidthMm` of the rim's vertices says (supported_walls.h; empty:
// the usual width), where there is room for it (outer_walls.h). Lines that wind have none.
// Preconditions: per-vertex arrays match, thickness > 0, options in range. Throws Cancelled,
// Error{Usage} for an unknown infill, or one that winds where the patch has no chart.
PatchCover coverPatch(const layers::Patch& patch, const process::Process& process,
                      const ToolpathOptions& options, const base::RunContext& ctx,
                      const std::vector<double>& wallWidthMm = {});

} // namespace voluta::toolpath
