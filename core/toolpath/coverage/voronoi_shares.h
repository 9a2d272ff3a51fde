// Which part of a patch belongs to which stretch of bead: every sample of the patch to the nearest
// centreline. A stretch's share says how much material it has to lay and where its middle is.
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
  std::vector<double> lateralMm; // mean signed distance of its samples, positive to the left
  double beyondMm2[2] = {0, 0};  // open curves: area that lies past the first and the last point
};

struct VoronoiShares {
  std::vector<CellShare> share; // per curve
  double orphanMm2 = 0.0;       // further than the reach from any curve
};

// `extraMm`: per curve, per point, >= 0: by how much nearer than it is a sample counts, half of
// what the curve's bead is wider than others; empty for a curve, or for all: 0.
VoronoiShares assignToNearestCurve(const SampleGrid& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm = {});
// The same of a plane surface. `even`: what its curves have without samples.
VoronoiShares assignToNearestCurve(const PlaneSamples& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm = {},
                                   const UniformStretches& even = {});

} // namespace voluta::toolpath
