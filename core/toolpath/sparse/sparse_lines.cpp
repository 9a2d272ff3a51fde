#include "toolpath/sparse/sparse_lines.h"

#include "base/index.h"
#include "base/units.h"
#include "geometry/least_turn.h"
#include "geometry/nearest_share.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/coverage/line_cover.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/patch_surface.h"
#include "toolpath/sparse/branches.h"
#include "toolpath/sparse/patterns.h"
#include "toolpath/sparse/pith_grading.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Matrix3d;
using Eigen::Vector3d;

using base::at;

// [periods]: ends farther apart are not joined. LineCover's limit is 8 of its spacings.
constexpr double kFarthestJoin = 1.6 / 8.0;
constexpr double kOverlap = 0.25; // [beads] by which free ends reach into their neighbour
constexpr int kSmoothPasses = 2;

// Returns the pattern's coordinates of each vertex.
std::vector<Vector3d> coordinates(const PatchSurface& s, const PatternFrame& frame,
                                  double repeatMm) {
  std::vector<Vector3d> at(s.position.size());
  if (s.chart.empty()) {
    for (std::size_t v = 0; v < at.size(); ++v)
      at[v] = frame.fromWork * s.position[v];
    return at;
  }
  // Around the axis, the pattern repeats a whole number of times on every layer.
  const double around = 2.0 * base::kPi * frame.radiusMm;
  const double total = repeatMm * std::max(1.0, std::round(around / repeatMm));
  const double perU = s.chart.periodMm > 0.0 ? total / s.chart.periodMm : 1.0;
  const double radius = s.chart.periodMm / (2.0 * base::kPi);
  for (std::size_t v = 0; v < at.size(); ++v)
    at[v] = {s.chart.at[v].y(), perU * s.chart.at[v].x(), radius};
  return at;
}

// Returns per vertex the distance from the innermost wall of the patch that the surface is a part
// of [mm]. Measured straight, since the patch's own surface is not at hand.
std::vector<double> distanceFromWalls(const PatchSurface& s, const layers::Patch& patch,
                                      double wallsMm) {
  const PatchSurface whole = PatchSurface::refine(patch, 1e9);
  const std::vector<SourceSegment> edges = boundaryParts(whole).surface;
  std::vector<double> mm(s.position.size(), 0.0);
  for (std::size_t v = 0; v < mm.size(); ++v) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const SourceSegment& edge : edges) {
      const double t = geometry::nearestShare(s.position[v], edge.a, edge.b);
      minimum = std::min(minimum, (s.position[v] - edge.a - t * (edge.b - edge.a)).squaredNorm());
    }
    mm[v] = std::sqrt(minimum) - wallsMm;
  }
  return mm;
}

// Returns the area that each vertex represents [mm2].
std::vector<double> areasOf(const PatchSurface& s) {
  std::vector<double> area(s.position.size(), 0.0);
  for (const auto& t : s.triangles) {
    const Vector3d &a = s.position[at(t[0])], &b = s.position[at(t[1])], &c = s.position[at(t[2])];
    for (const int v : t)
      area[at(v)] += (b - a).cross(c - a).norm() / 6.0;
  }
  return area;
}

// Removes the triangles over which the chart's u jumps by a period, so that no line is drawn over
// them.
layers::Patch withoutSeam(const layers::Patch& patch) {
  layers::Patch open = patch;
  if (!patch.chart.empty() && patch.chart.periodMm > 0.0)
    std::erase_if(open.surface.triangles, [&](const std::array<int, 3>& t) {
      const auto [low, high] =
          std::minmax({patch.chart.at[at(t[0])].x(), patch.chart.at[at(t[1])].x(),
                       patch.chart.at[at(t[2])].x()});
      return high - low > 0.5 * patch.chart.periodMm;
    });
  return open;
}

// Returns per vertex the number of layers to the skin above, at most `maximum`.
std::vector<int> layersToSkin(const PatchSurface& s, std::size_t patch, const LayerCount& count,
                              const ToolpathOptions& o, int maximum) {
  std::vector<int> left(s.position.size(), maximum);
  if (maximum == 0 || o.topLayers == 0)
    return left;
  for (std::size_t v = 0; v < left.size(); ++v) {
    const int skin =
        std::max(o.topLayers, static_cast<int>(std::ceil(o.skinMm / s.thicknessMm[v] - 1e-6)));
    const int above =
        count.along(patch, s.position[v], s.direction[v], s.thicknessMm[v], skin + maximum).count;
    left[v] = std::clamp(above - skin, 0, maximum);
  }
  return left;
}

void addLines(const PatchSurface& s, const std::vector<double>& values, LineCover& cover,
              const base::RunContext& ctx) {
  const auto [low, high] = std::ranges::minmax(values);
  const double first = std::floor(low - 0.5);
  const int count = static_cast<int>(std::ceil(high + 0.5) - first);
  const EvenIsolines levels(s, values, first, 1.0, count);
  for (int k = 0; k < count; ++k) {
    ctx.checkpoint();
    for (SurfaceCurve& c : levels.curvesAt(k)) {
      smoothCurve(s, c, std::vector<char>(c.points.size(), 0), kSmoothPasses);
      cover.add(c, k);
    }
  }
}

std::vector<SurfaceCurve> patternCurves(const InfillRegion& region, const SparsePattern& pattern,
                                        const SparsePlace& place, const process::Process& process,
                                        const ToolpathOptions& o, const base::RunContext& ctx) {
  const PatchSurface& s = region.surface;
  const double bead = process.beadWidthMm;
  const double period = pattern.periodMm(o.infillDensity, region.hatchMm.front(), bead);
  const PatternValue value = pattern.value(period, bead);
  std::vector<Vector3d> where = coordinates(s, place.frame, pattern.repeatsAfter * period);
  if (pattern.followsWalls) {
    const std::vector<double> mm =
        distanceFromWalls(s, place.stack.patches[place.patch], o.walls * region.hatchMm.front());
    const PithGrading grading = pattern.isGraded && o.infillDensity < 1.0
                                    ? pithGrading(mm, areasOf(s), o.infillDensity)
                                    : PithGrading{};
    for (std::size_t v = 0; v < where.size(); ++v)
      where[v] = {0.0, grading.evenMm(mm[v]), 0.0};
  }
  const Branches branches = branchesOf(process, o);
  const std::vector<int> left = layersToSkin(s, place.patch, place.layers, o, branches.layers());
  std::vector<SurfaceCurve> curves;
  for (int stage = 0; stage < branches.stages(); ++stage) {
    std::vector<double> values(where.size()), depth = region.depth;
    bool isAny = false;
    for (std::size_t v = 0; v < where.size(); ++v) {
      values[v] = value(where[v], branches.of(left[v], stage));
      if (branches.stageOf(left[v]) == stage)
        isAny = true;
      else
        depth[v] = -1.0;
    }
    if (!isAny)
      continue;
    LineCover cover(region, depth);
    addLines(s, values, cover, ctx);
    std::ranges::move(cover.joined(kFarthestJoin * period, ctx), std::back_inserter(curves));
  }
  return curves;
}

// Moves the ends of an open bead outwards.
void extendEnds(Bead& bead, double byMm) {
  if (bead.closed || bead.points.size() < 2)
    return;
  const auto extend = [&](BeadPoint& end, const BeadPoint& before) {
    end.middle += byMm * (end.middle - before.middle).normalized();
  };
  extend(bead.points.front(), bead.points[1]);
  extend(bead.points.back(), bead.points[bead.points.size() - 2]);
}

Bead beadAlong(const PatchSurface& s, const SurfaceCurve& curve, const process::Process& process,
               double stepMm) {
  ResampleOptions options = ResampleOptions().scaled(largeBeadScaleOf(process));
  options.stepMm = stepMm;
  const SurfaceCurve c = resample(s, curve, options).curve;
  Bead bead;
  bead.kind = plan::PathKind::SparseInfill;
  bead.closed = c.closed;
  for (const SurfacePoint& p : c.points) {
    const double height = s.interpolate(s.thicknessMm, p);
    bead.points.push_back({p.position, s.interpolate(s.direction, p),
                           s.interpolate(s.clearDirection, p),
                           std::max(process.beadWidthMm, height), height});
  }
  if (c.closed)
    bead.points.push_back(bead.points.front());
  extendEnds(bead, kOverlap * process.beadWidthMm);
  return bead;
}
} // namespace

std::vector<PatternFrame> patternFrames(const layers::LayerStack& stack,
                                        const ToolpathOptions& options) {
  struct Sum {
    Vector3d direction = Vector3d::Zero();
    double periodMm = 0.0;
    int charts = 0;
  };
  std::map<std::pair<int, int>, Sum> groups;
  for (const layers::Patch& patch : stack.patches) {
    Sum& sum = groups[{patch.item, patch.group}];
    for (const Vector3d& direction : patch.direction)
      sum.direction += direction;
    sum.periodMm += patch.chart.periodMm;
    sum.charts += patch.chart.periodMm > 0.0;
  }
  const double angle = base::degreesToRadians(options.infillAngleDeg + 45.0);
  const Matrix3d turned = Eigen::AngleAxisd(-angle, Vector3d::UnitZ()).toRotationMatrix();
  std::vector<PatternFrame> frames;
  for (const layers::Patch& patch : stack.patches) {
    const Sum& sum = groups[{patch.item, patch.group}];
    PatternFrame frame;
    const Vector3d up = sum.direction.norm() > 1e-6 ? Vector3d(sum.direction.normalized())
                                                    : Vector3d(Vector3d::UnitZ());
    frame.fromWork =
        turned * geometry::shortestRotation(Vector3d::UnitZ(), up).inverse().toRotationMatrix();
    frame.radiusMm = sum.periodMm / std::max(1, sum.charts) / (2.0 * base::kPi);
    frames.push_back(frame);
  }
  return frames;
}

std::vector<Bead> sparseBeads(const layers::Patch& patch, const SparsePlace& place,
                              const process::Process& process, const ToolpathOptions& o,
                              const base::RunContext& ctx) {
  const SparsePattern& pattern = sparsePattern(o.sparsePattern);
  if (o.infillDensity <= 0.0 || patch.surface.empty())
    return {};
  const PatchSurface s = PatchSurface::refine(withoutSeam(patch), o.edgeMm);
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  std::vector<double> depth = distanceToSegments(s, boundarySegments(s), 1e9);
  for (double& d : depth)
    d /= hatch;
  const std::vector<double> hatchMm(depth.size(), hatch);
  InfillRegion region{s, depth, hatchMm};
  region.beadScale = beadScaleOf(process);
  std::vector<Bead> beads;
  for (const SurfaceCurve& curve : patternCurves(region, pattern, place, process, o, ctx))
    beads.push_back(beadAlong(s, curve, process, o.stepMm));
  return beads;
}

} // namespace voluta::toolpath
