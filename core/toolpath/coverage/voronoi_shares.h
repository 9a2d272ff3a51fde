// Assigns every sample of a patch to the nearest centreline. A segment's share determines how much
// material it has to deposit and where the middle of that material is.
#pragma once

#include "toolpath/coverage/plane_samples.h"
#include "toolpath/coverage/sample_grid.h"
#include "toolpath/coverage/uniform_interior.h"
#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct CellShare {
  // Per segment of the curve (a closed curve has as many segments as points).
  std::vector<double> areaMm2, volumeMm3;
  std::vector<double> leftMm2; // the part of areaMm2 to the left of the segment
  // Mean signed distance of the segment's samples, positive to the left
  std::vector<double> lateralMm;
  double beyondMm2[2] = {0, 0}; // Open curves: area beyond the first and the last point
};

struct VoronoiShares {
  std::vector<CellShare> share; // Per curve
  double orphanMm2 = 0.0;       // Farther than the reach from any curve
};

// `extraMm`: per curve and point, >= 0: the distance by which samples count as nearer, half of the
// bead's additional width; empty for a curve, or for all: 0.
VoronoiShares assignToNearestCurve(const SampleGrid& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm = {});
// The same for a plane surface. `even`: the shares of its curves that need no samples.
VoronoiShares assignToNearestCurve(const PlaneSamples& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm = {},
                                   const UniformStretches& even = {});

} // namespace voluta::toolpath
