// Kinds of infill: one row in the table and one file each.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "toolpath/patch_surface.h"

#include <span>
#include <string_view>
#include <vector>

namespace voluta::toolpath {

// The region to be filled: where `depth` >= `from`.
struct InfillRegion {
  const PatchSurface& surface;
  const std::vector<double>& depth;   // per vertex: distance from the boundary, in hatches
  const std::vector<double>& hatchMm; // per vertex: distance of neighbouring beads
  double from = 0.0;
  double density = 1.0;      // (0, 1]
  int layer = 0;             // direction alternates with it
  double directionRad = 0.0; // of straight lines on a flat layer, from x to y
  double windingRad = 0.0;   // of helical lines from the way around, [0, pi/2]
  double beadScale = 1.0;    // bead_scale.h
};

// What an infill lays over its region.
struct InfillLines {
  std::vector<SurfaceCurve> curves;
  // Per vertex of a plane surface, mm: how far apart lines run there, straight and side by side;
  // 0 where they may not, as near the region's edge. Empty: 0 everywhere.
  std::vector<double> uniformSpacingMm = {};
};

struct InfillKind {
  std::string_view id;
  base::Text label;
  // Centrelines, in an order fit for printing, open or closed, none outside the region. Throws
  // Cancelled, a few lines later at most.
  InfillLines (*fill)(const InfillRegion&, const base::RunContext&);
  // Lines wind around an axis: for surfaces with a chart, on which they are even as they are.
  bool needsChart = false;
  // Lines of wide regions go straight through, whatever way the boundary runs.
  bool isStraightInside = false;
};
// All kinds; the first is the default.
std::span<const InfillKind> infillKinds();
// Throws Error{Usage}, naming the nearest.
const InfillKind& infillKind(std::string_view id);

// Parallel curves at equal distances on the surface, joined end to end, in the region's direction.
// Narrow parts of the region are filled as by concentricInfill.
InfillLines zigzagInfill(const InfillRegion& region, const base::RunContext& ctx);
// Curves at equal distances from the boundary.
InfillLines concentricInfill(const InfillRegion& region, const base::RunContext& ctx);

// Lines that are straight in the surface's chart (Castelli 5.3.1, appendix A). Where the region
// goes all the way around, their number around is whole, so that they run on over the chart's seam;
// elsewhere they are joined end to end. Precondition: the surface has a chart.
// One helix a region; between straight ends its first and last turn narrow down to the ends.
InfillLines aroundInfill(const InfillRegion& region, const base::RunContext& ctx);
InfillLines alongInfill(const InfillRegion& region, const base::RunContext& ctx);
// At windingRad, to one side and to the other in turns of layers.
InfillLines helicalInfill(const InfillRegion& region, const base::RunContext& ctx);
// Around and along in turns of layers.
InfillLines wovenInfill(const InfillRegion& region, const base::RunContext& ctx);

} // namespace voluta::toolpath
