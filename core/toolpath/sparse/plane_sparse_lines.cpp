#include "toolpath/sparse/plane_sparse_lines.h"

#include "base/index.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/plane/contours.h"
#include "toolpath/plane/joined_lines.h"
#include "toolpath/plane/spaced_points.h"
#include "toolpath/sparse/branches.h"
#include "toolpath/sparse/patterns.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kOverlap = 0.25;     // [beads] by which free ends reach into their neighbour
constexpr double kShortest = 1.5;     // [beads]
constexpr double kFarthestJoin = 1.6; // [spacings]
// Joints add at most this share to the asked one.
constexpr double kJoinedShare = 0.02;
// Of the distance between lines, and [beads] where lines turn away from each other
constexpr double kGridOfSpacing = 0.125, kGridOfBead = 0.5;

PlaneBox boxAround(const ClipperLib::Paths& area) {
  PlaneBox box{Vector2d::Constant(INFINITY), Vector2d::Constant(-INFINITY)};
  for (const ClipperLib::Path& path : area)
    for (const ClipperLib::IntPoint& p : path) {
      box.low = box.low.cwiseMin(geometry::pointMm(p));
      box.high = box.high.cwiseMax(geometry::pointMm(p));
    }
  return box;
}

// Returns the pattern's lines over the area and a little beyond its edge.
std::vector<PlaneLine> linesOver(const ClipperLib::Paths& area, double stepMm,
                                 const std::function<double(const Vector2d&)>& value) {
  PlaneBox box = boxAround(area);
  box.low.array() -= 1.5 * stepMm;
  box.high.array() += 1.5 * stepMm;
  const Contours wide(geometry::offsetPaths(area, 1.5 * stepMm, {0.1 * stepMm}));
  return fieldLines(box, stepMm, value, [&](const Vector2d& p) { return wide.contains(p); });
}

Bead beadAlong(const PlaneLine& line, const PlanePatch& plane, const process::Process& process) {
  Bead bead;
  bead.kind = plan::PathKind::SparseInfill;
  bead.closed = line.isClosed;
  const double height = plane.thicknessMm;
  for (const Vector2d& p : line.points)
    bead.points.push_back({plane.place(p), plane.direction, plane.clearDirection,
                           std::max(process.beadWidthMm, height), height});
  if (bead.closed)
    bead.points.push_back(bead.points.front());
  return bead;
}

// Returns the parts of `area` with at least 0, 1, 2, … sparse layers above them, each within the
// one before.
std::vector<ClipperLib::Paths> belowSparse(const ClipperLib::Paths& area,
                                           const std::vector<ClipperLib::Paths>& above) {
  std::vector<ClipperLib::Paths> parts{area};
  for (const ClipperLib::Paths& next : above)
    parts.push_back(geometry::combined(parts.back(), next, ClipperLib::ctIntersection));
  return parts;
}

// The lines of a pattern in one layer.
class PatternLines {
public:
  PatternLines(const SparsePattern& pattern, double periodMm, const process::Process& process,
               const std::function<Vector3d(const Vector2d&)>& place)
      : value_(pattern.value(periodMm, process.beadWidthMm)), place_(place),
        stepMm_(kGridOfSpacing * pattern.spacing * periodMm),
        fineStepMm_(std::min(stepMm_, kGridOfBead * process.beadWidthMm)) {
    if (pattern.cornerLoss > 0.0)
      stepMm_ = fineStepMm_;
  }

  std::vector<PlaneLine> over(const ClipperLib::Paths& area) const {
    return linesOver(area, stepMm_, [&](const Vector2d& p) { return value_(place_(p), {}); });
  }

  // The lines of one stage of branching. `parts`: of belowSparse().
  std::vector<PlaneLine> branched(const ClipperLib::Paths& area, const Branches& branches,
                                  int stage, const std::vector<Contours>& parts) const {
    const auto layersToSkin = [&](const Vector2d& p) {
      std::size_t left = 0;
      while (left + 1 < parts.size() && parts[left + 1].contains(p))
        ++left;
      return static_cast<int>(left);
    };
    return linesOver(area, fineStepMm_, [&](const Vector2d& p) {
      return value_(place_(p), branches.of(layersToSkin(p), stage));
    });
  }

private:
  PatternValue value_;
  const std::function<Vector3d(const Vector2d&)>& place_;
  double stepMm_, fineStepMm_;
};
} // namespace

std::vector<Bead> planeSparseBeads(const PlanePatch& plane, const ClipperLib::Paths& area,
                                   const PatternFrame& frame,
                                   const std::vector<ClipperLib::Paths>& above,
                                   const process::Process& process, const ToolpathOptions& o,
                                   const base::RunContext& ctx) {
  if (o.infillDensity <= 0.0 || area.empty())
    return {};
  const SparsePattern& pattern = sparsePattern(o.sparsePattern);
  const double beadMm = process.beadWidthMm,
               hatch = process::hatchOf(beadMm, process.layerHeightMm);
  const double period = pattern.periodMm(o.infillDensity, hatch, beadMm);
  const Branches branches = branchesOf(process, o);
  const std::function<Vector3d(const Vector2d&)> place = [&](const Vector2d& p) -> Vector3d {
    return frame.fromWork * plane.place(p);
  };
  const PatternLines lines(pattern, period, process, place);
  LineJoints joints;
  joints.insetMm = 0.5 * hatch;
  joints.overlapMm = kOverlap * beadMm;
  joints.shortestMm = kShortest * beadMm;
  std::vector<PlaneLine> joined;
  const auto add = [&](const std::vector<PlaneLine>& more, const ClipperLib::Paths& within) {
    std::ranges::move(joinedLines(more, within, joints, ctx), std::back_inserter(joined));
  };
  const int layers = o.topLayers == 0 ? 0 : branches.layers();
  if (layers == 0) {
    joints.longestMm = kFarthestJoin * pattern.spacing * period;
    joints.totalMm = kJoinedShare * geometry::areaMm2(area) / hatch;
    add(lines.over(area), area);
  } else {
    const std::vector<ClipperLib::Paths> parts = belowSparse(area, above);
    const std::vector<Contours> contours(parts.begin(), parts.end());
    for (int left = 0, next = 0; left <= layers; left = next) {
      ctx.checkpoint();
      const int stage = branches.stageOf(left);
      while (next <= layers && branches.stageOf(next) == stage)
        ++next;
      if (base::at(left) >= parts.size())
        break;
      const ClipperLib::Paths own =
          base::at(next) < parts.size()
              ? geometry::combined(parts[base::at(left)], parts[base::at(next)],
                                   ClipperLib::ctDifference)
              : parts[base::at(left)];
      if (!own.empty())
        add(lines.branched(own, branches, stage, contours), own);
    }
  }
  const ResampleOptions points = ResampleOptions().scaled(largeBeadScaleOf(process));
  std::vector<Bead> beads;
  for (const PlaneLine& line : joined)
    beads.push_back(beadAlong(spacedPoints(line, points.chordMm, o.stepMm), plane, process));
  return beads;
}

} // namespace voluta::toolpath
