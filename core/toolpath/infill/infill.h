// Kinds of infill: one row of the table and one file each.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "toolpath/options.h"
#include "toolpath/patch_surface.h"

#include <span>
#include <string_view>
#include <vector>

namespace voluta::toolpath {

// The region to be filled: where `depth` >= `from`.
struct InfillRegion {
  const PatchSurface& surface;
  const std::vector<double>& depth;   // Per vertex: distance from the boundary [hatches]
  const std::vector<double>& hatchMm; // Per vertex: distance between neighbouring beads
  double from = 0.0;
  int layer = 0;             // The direction alternates with the layer
  double directionRad = 0.0; // Direction of straight lines on a flat layer, from x towards y
  double windingRad = 0.0;   // Angle of helical lines from the circumferential direction, [0, pi/2]
  double beadScale = 1.0;    // See bead_scale.h
  const StrandDyads* strands = nullptr; // of fieldInfill
};

// The lines of an infill in its region.
struct InfillLines {
  std::vector<SurfaceCurve> curves;
  // Per vertex of a plane surface [mm]: the distance between straight parallel lines there; 0 where
  // lines need not be straight and parallel, as near the region's edge. Empty: 0 everywhere.
  std::vector<double> uniformSpacingMm = {};
  // Per vertex: the lines are the only beads there, and widen to close the gaps between them.
  // Empty: nowhere.
  std::vector<char> isClosed = {};
  bool lacksField = false; // of fieldInfill: the field has no direction in the surface
};

struct InfillKind {
  std::string_view id;
  base::Text label;
  // Returns centrelines in an order suitable for printing, open or closed, none outside the region.
  // Throws Cancelled at the latest a few lines after cancellation.
  InfillLines (*fill)(const InfillRegion&, const base::RunContext&);
  // Lines wind around an axis. Requires a surface with a chart, on which the lines are already
  // evenly spaced.
  bool needsChart = false;
  // In wide regions lines are straight, independent of the boundary.
  bool isStraightInside = false;
};
// Returns all kinds; the first is the default.
std::span<const InfillKind> infillKinds();
// Throws Error{Usage} for an unknown id, suggesting the nearest.
const InfillKind& infillKind(std::string_view id);

// Parallel curves at equal distances on the surface, joined end to end, in the region's direction.
// Narrow parts of the region are filled as by concentricInfill.
InfillLines zigzagInfill(const InfillRegion& region, const base::RunContext& ctx);
// As zigzagInfill, along the directions of a field instead of one direction: isolines of a function
// whose gradient is across them, by least squares. Where they come closer than beads can be narrow,
// every other line ends; where they are farther apart than beads can be wide, lines begin between
// them. A part where the field has no direction is filled as by zigzagInfill. Throws Error{Usage}
// without a field.
InfillLines fieldInfill(const InfillRegion& region, const base::RunContext& ctx);
// Curves at equal distances from the boundary.
InfillLines concentricInfill(const InfillRegion& region, const base::RunContext& ctx);
// The curves of concentricInfill joined to one closed curve per connected region: a double spiral
// where they are nested without branching (connected Fermat spirals, Zhao et al. 2016), joined side
// by side where they branch and around holes.
InfillLines fermatInfill(const InfillRegion& region, const base::RunContext& ctx);

// Lines that are straight in the surface's chart (Castelli 5.3.1, appendix A). Where the region
// extends all the way around, their number is an integer, so that they continue across the chart's
// seam; elsewhere they are joined end to end. Precondition: the surface has a chart. aroundInfill:
// one helix per region; if the region's ends are straight, the bead of the first and last turn
// narrows towards the end.
InfillLines aroundInfill(const InfillRegion& region, const base::RunContext& ctx);
InfillLines alongInfill(const InfillRegion& region, const base::RunContext& ctx);
// Lines at windingRad, alternating sides from layer to layer.
InfillLines helicalInfill(const InfillRegion& region, const base::RunContext& ctx);
// Alternates `around` and `along` from layer to layer.
InfillLines wovenInfill(const InfillRegion& region, const base::RunContext& ctx);

} // namespace voluta::toolpath
