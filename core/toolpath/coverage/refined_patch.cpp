#include "toolpath/coverage/refined_patch.h"

#include "base/index.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

// Depth [hatches] beyond which only straight lines are printed, which do not depend on the distance
// to the boundary.
constexpr double kFineDepth = 5.5;
constexpr double kCoarser = 2.0; // Edge length factor there

// Marks the vertices of triangles over which the distance from the boundary, per vertex, rises
// slowly: fronts from different parts of the boundary meet there.
std::vector<char> ridgeMarks(const PatchSurface& s, const std::vector<double>& depthMm,
                             double hatchMm) {
  constexpr double kFlatter = 0.8; // Share of the true gradient length, 1
  // [hatches]: deeper in, infill covers the ridge
  constexpr double kShallowest = 0.35, kDeepest = 5.0;
  std::vector<char> marks(s.position.size(), 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto v = [&](std::size_t k) { return at(s.triangles[t][k]); };
    const double deepest = std::max({depthMm[v(0)], depthMm[v(1)], depthMm[v(2)]});
    if (deepest < kShallowest * hatchMm || deepest > kDeepest * hatchMm || s.triangleArea[t] < 1e-9)
      continue;
    Vector3d gradient = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      gradient += depthMm[v(k)] * s.triangleNormal[t].cross(s.position[v((k + 2) % 3)] -
                                                            s.position[v((k + 1) % 3)]);
    if (gradient.norm() / (2 * s.triangleArea[t]) < kFlatter)
      marks[v(0)] = marks[v(1)] = marks[v(2)] = 1;
  }
  return marks;
}

// Marks the vertices of walls that are thinner than about a bead: those that a disc of half that
// width inside the patch does not reach.
std::vector<char> thinMarks(const PatchSurface& s, const std::vector<double>& depthMm,
                            double hatchMm) {
  constexpr double kHalfWidth = 0.6, kSlack = 0.25; // [hatches]
  const double reach = (kHalfWidth + kSlack) * hatchMm;
  const std::vector<double> off =
      distanceToSegments(s, segmentsOf(s, isolines(s, depthMm, kHalfWidth * hatchMm)), reach);
  std::vector<char> marks(s.position.size());
  for (std::size_t v = 0; v < marks.size(); ++v)
    marks[v] = depthMm[v] < kHalfWidth * hatchMm && off[v] >= reach;
  return marks;
}

// Refines the surface where fronts from opposite sides of the boundary meet. There the distance has
// a ridge that coarse triangles cut off, and its height decides whether one or two beads fit; in
// walls of less than a bead, whether one fits.
PatchSurface refineAtRidges(const PatchSurface& s, const process::Process& process) {
  constexpr double kFine = 0.2, kFinest = 0.12; // mm, for beads of 1.2 mm
  constexpr double kFarthest = 5.1;             // [hatches], more than the deepest ridge
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm),
               scale = beadScaleOf(process);
  const std::vector<double> depth = distanceToSegments(s, boundarySegments(s), kFarthest * hatch);
  const std::vector<char> thin = thinMarks(s, depth, hatch);
  PatchSurface fine = s.refinedAt(ridgeMarks(s, depth, hatch), kFine * scale);
  if (std::ranges::find(thin, 1) == thin.end())
    return fine;
  const std::vector<double> again = distanceToSegments(fine, boundarySegments(fine), hatch);
  return fine.refinedAt(thinMarks(fine, again, hatch), kFinest * scale);
}

// Returns the refined surface, coarser where only straight lines are printed.
PatchSurface refined(const layers::Patch& patch, const process::Process& process,
                     const ToolpathOptions& o, bool isStraightInside) {
  if (!isStraightInside)
    return PatchSurface::refine(patch, o.edgeMm);
  const PatchSurface coarse = PatchSurface::refine(patch, kCoarser * o.edgeMm);
  const double fine = std::max(kFineDepth, o.walls + kFineDepth - 2.0) *
                      process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const std::vector<double> depthMm = distanceToSegments(coarse, boundarySegments(coarse), fine);
  std::vector<char> marks(depthMm.size());
  for (std::size_t v = 0; v < marks.size(); ++v)
    marks[v] = depthMm[v] < fine;
  return coarse.refinedAt(std::move(marks), o.edgeMm);
}
} // namespace

PatchSurface refinedPatch(const layers::Patch& patch, const process::Process& process,
                          const ToolpathOptions& options, bool isStraightInside) {
  return refineAtRidges(refined(patch, process, options, isStraightInside), process);
}

} // namespace voluta::toolpath
