#include "base/parallel.h"
#include "geometry/triangle_queries.h"
#include "replay/comparison.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;

class DeviationSearch {
public:
  DeviationSearch(const ExecutedPath& path, const PlannedNozzle& planned,
                  const plan::Trajectory& trajectory, const plan::ReadProgram& program,
                  const Alignment& alignment, const WholePath* whole)
      : path_(path), planned_(planned), trajectory_(trajectory), program_(program),
        alignment_(alignment), whole_(whole) {}

  // Adds motion m to `w`.
  void add(std::size_t m, PathDeviation& w) const {
    const std::size_t j = alignment_.pointAhead(m);
    if (j == kUnmatched)
      return;
    const bool piece = alignment_.pointOf[m] == kUnmatched;
    const double angle = std::atan2(path_.targetDirection[m].cross(planned_.direction[j]).norm(),
                                    path_.targetDirection[m].dot(planned_.direction[j]));
    if (program_.tellsDirections && !piece)
      w.rad = std::max(w.rad, angle);
    // A dialect without joint motions moves straight where the plan has a free travel.
    const bool endOnly = m == 0 || trajectory_.move[j] == plan::MoveKind::Joint;
    if (endOnly && piece)
      return;
    const double mm = std::max(fromPlan(m, j, endOnly), endOnly ? 0.0 : fromMotion(m, j));
    if (mm > w.mm) {
      w.mm = mm;
      w.motion = m;
    }
  }

private:
  std::size_t pointBefore(std::size_t m) const {
    return m > 0 ? alignment_.pointOf[m - 1] : kUnmatched;
  }
  const std::vector<Vector3d>& polyline() const {
    return whole_ ? whole_->planned.tip : planned_.tip;
  }
  std::size_t ofPolyline(std::size_t j) const { return whole_ ? whole_->lastOf[j] : j; }

  // Returns the largest distance of the motion's samples from the plan. A target off its planned
  // point may still be on the planned line: that is no deviation of the path.
  double fromPlan(std::size_t m, std::size_t j, bool endOnly) const {
    constexpr std::size_t kMaxSegments = 64;
    const std::size_t before = pointBefore(m);
    const std::size_t first =
        ofPolyline(before < j ? std::max(before, j > kMaxSegments ? j - kMaxSegments : 0)
                              : (j > 0 ? j - 1 : 0));
    const std::size_t last = ofPolyline(std::min(j + 1, planned_.tip.size() - 1));
    const bool blended = program_.motions[m].blendMm > 0.0;
    double maximum = 0.0;
    for (std::size_t s = path_.firstSample[m]; s < path_.firstSample[m + 1]; ++s) {
      if (endOnly && s + 1 < path_.firstSample[m + 1])
        continue;
      double d = (path_.tip[s] - planned_.tip[j]).norm();
      if (!(endOnly && !blended))
        for (std::size_t k = first; k < last; ++k)
          d = std::min(d,
                       geometry::distanceToSegment(path_.tip[s], polyline()[k], polyline()[k + 1]));
      maximum = std::max(maximum, d);
    }
    return maximum;
  }

  // Returns the largest distance of the omitted points from the motion that replaces them.
  double fromMotion(std::size_t m, std::size_t j) const {
    if (!whole_ || m == 0 || j == 0 || alignment_.pointOf[m] != j || pointBefore(m) + 1 != j)
      return 0.0;
    double maximum = 0.0;
    for (std::size_t i = whole_->lastOf[j - 1] + 1; i < whole_->lastOf[j]; ++i) {
      const Vector3d& point = whole_->planned.tip[i];
      Vector3d from =
          path_.firstSample[m] > 0 ? path_.tip[path_.firstSample[m] - 1] : path_.targetTip[m - 1];
      double d = (point - from).norm();
      for (std::size_t s = path_.firstSample[m]; s < path_.firstSample[m + 1]; ++s) {
        d = std::min(d, geometry::distanceToSegment(point, from, path_.tip[s]));
        from = path_.tip[s];
      }
      maximum = std::max(maximum, d);
    }
    return maximum;
  }

  const ExecutedPath& path_;
  const PlannedNozzle& planned_;
  const plan::Trajectory& trajectory_;
  const plan::ReadProgram& program_;
  const Alignment& alignment_;
  const WholePath* whole_;
};

} // namespace

std::optional<WholePath> wholePath(const WholePlan& whole, const plan::Trajectory& merged,
                                   const robot::Cell& cell, const base::RunContext& ctx) {
  if (!whole.trajectory || whole.trajectory->pointCount() == merged.pointCount())
    return std::nullopt;
  WholePath path{plannedNozzle(*whole.trajectory, cell, ctx),
                 std::vector<std::size_t>(merged.pointCount(), 0)};
  for (std::size_t i = 0; i < whole.mergedPoint.size(); ++i)
    path.lastOf[whole.mergedPoint[i]] = i;
  return path;
}

PathDeviation pathDeviation(const ExecutedPath& path, const PlannedNozzle& planned,
                            const plan::Trajectory& trajectory, const plan::ReadProgram& program,
                            const Alignment& alignment, const base::RunContext& ctx,
                            const WholePath* whole) {
  constexpr std::size_t kGrain = 4096;
  const DeviationSearch search(path, planned, trajectory, program, alignment, whole);
  std::vector<PathDeviation> worst((path.motionCount() + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, path.motionCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m)
      search.add(m, worst[begin / kGrain]);
  });
  PathDeviation result;
  for (const PathDeviation& w : worst) {
    result.rad = std::max(result.rad, w.rad);
    if (w.mm > result.mm) {
      result.mm = w.mm;
      result.motion = w.motion;
    }
  }
  return result;
}

} // namespace voluta::replay
