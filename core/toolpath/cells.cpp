#include "toolpath/cells.h"

#include "base/error.h"
#include "toolpath/segment_grid.h"
#include "toolpath/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {

// Of the reach: what is nearer to a plane's curves is painted by them, the rest looks for its own.
constexpr double kPainted = 0.4;

// Gives samples of a surface to the nearest segment of the curves.
class Sharer {
public:
  Sharer(const std::vector<SurfaceCurve>& curves, double reachMm,
         const std::vector<std::vector<double>>& extraMm)
      : curves_(curves), reach_(reachMm) {
    cells_.share.resize(curves.size());
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto& points = curves[c].points;
      const std::size_t n = points.size() - (curves[c].closed ? 0 : 1);
      cells_.share[c].areaMm2.assign(n, 0.0);
      cells_.share[c].volumeMm3.assign(n, 0.0);
      cells_.share[c].lateralMm.assign(n, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        segments_.push_back({points[i].position, points[(i + 1) % points.size()].position});
        owner_.emplace_back(c, i);
        if (!extraMm.empty()) {
          const std::vector<double>& extra = extraMm[c];
          extra_.push_back(extra.empty() ? std::array{0.0, 0.0}
                                         : std::array{extra[i], extra[(i + 1) % points.size()]});
          mostExtra_ = std::max({mostExtra_, extra_.back()[0], extra_.back()[1]});
        }
      }
    }
  }

  void add(const SurfaceSample& sample, const Eigen::Vector3d& normal) {
    give(sample, normal, nearest(sample.position));
  }

  void add(const PlaneSamples& samples) {
    const std::vector<int> nearest = painted(samples);
    for (std::size_t cell = 0; cell < samples.count(); ++cell) {
      if (!samples.isInside(cell))
        continue;
      const SurfaceSample sample = samples.sample(cell);
      if (nearest[cell] >= 0)
        give(sample, samples.normal(), hitOf(nearest[cell], sample.position));
      else
        add(sample, samples.normal());
    }
  }

  Cells finish() {
    for (CellShare& share : cells_.share)
      for (std::size_t i = 0; i < share.areaMm2.size(); ++i)
        if (share.areaMm2[i] > 0)
          share.lateralMm[i] /= share.areaMm2[i];
    return std::move(cells_);
  }

private:
  void give(const SurfaceSample& sample, const Eigen::Vector3d& normal,
            const SegmentGrid::Hit& hit) {
    const Eigen::Vector3d& p = sample.position;
    const double area = sample.areaMm2;
    if (hit.segment < 0) {
      cells_.orphanMm2 += area;
      return;
    }
    const auto [c, i] = owner_[static_cast<std::size_t>(hit.segment)];
    CellShare& share = cells_.share[c];
    share.areaMm2[i] += area;
    share.volumeMm3[i] += area * sample.thicknessMm;
    const auto& points = curves_[c].points;
    if (!curves_[c].closed && i == 0 && hit.t <= 0)
      share.beyondMm2[0] += area;
    else if (!curves_[c].closed && i + 2 == points.size() && hit.t >= 1)
      share.beyondMm2[1] += area;
    const Eigen::Vector3d along = points[(i + 1) % points.size()].position - points[i].position;
    const double length = along.norm();
    if (length > 1e-9)
      share.lateralMm[i] += area * normal.cross(along / length).dot(p - hit.point);
  }

  SegmentGrid::Hit nearest(const Eigen::Vector3d& p) {
    if (!grid_)
      grid_.emplace(segments_, reach_);
    const SegmentGrid::Hit hit = grid_->nearest(p, last_);
    last_ = hit.segment;
    return hit.segment >= 0 && mostExtra_ > 0.0 ? nearestOfWide(p, hit) : hit;
  }

  SegmentGrid::Hit hitOf(int segment, const Eigen::Vector3d& p) const {
    const auto& [a, b] = segments_[static_cast<std::size_t>(segment)];
    const double squared = (b - a).squaredNorm();
    SegmentGrid::Hit hit;
    hit.segment = segment;
    hit.t = squared > 0.0 ? std::clamp((b - a).dot(p - a) / squared, 0.0, 1.0) : 0.0;
    hit.point = (1.0 - hit.t) * a + hit.t * b;
    hit.distanceMm = (p - hit.point).norm();
    return hit;
  }

  // Per cell, what nearest() finds, where that is so near that no other segment can be nearer than
  // those that paint it; else -1.
  std::vector<int> painted(const PlaneSamples& samples) const {
    const double near = kPainted * reach_;
    std::vector<int> nearest(samples.count(), -1);
    std::vector<float> least(samples.count(),
                             static_cast<float>(extra_.empty() ? near * near : near));
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto& [a, b] = segments_[i];
      const auto offer = [&](std::size_t cell, float distance) {
        if (distance < least[cell]) {
          least[cell] = distance;
          nearest[cell] = static_cast<int>(i);
        }
      };
      if (extra_.empty()) {
        samples.forEachNear(a, b, near,
                            [&](std::size_t cell, float squared, float) { offer(cell, squared); });
        continue;
      }
      const auto from = static_cast<float>(extra_[i][0]), to = static_cast<float>(extra_[i][1]);
      samples.forEachNear(a, b, std::min(reach_, near + std::max(extra_[i][0], extra_[i][1])),
                          [&](std::size_t cell, float squared, float t) {
                            offer(cell, std::sqrt(squared) - (from + t * (to - from)));
                          });
    }
    return nearest;
  }

  double extraAt(int segment, double t) const {
    const auto& [from, to] = extra_[static_cast<std::size_t>(segment)];
    return (1.0 - t) * from + t * to;
  }

  // The segment whose bead's rim is nearest, among those that a wide one may take from `nearest`.
  SegmentGrid::Hit nearestOfWide(const Eigen::Vector3d& p, const SegmentGrid::Hit& nearest) const {
    SegmentGrid::Hit best = nearest;
    double least = nearest.distanceMm - extraAt(nearest.segment, nearest.t);
    grid_->forEachWithin(p, std::min(reach_, least + mostExtra_),
                         [&](int segment, double t, double distance) {
                           const double rim = distance - extraAt(segment, t);
                           if (rim < least || (rim == least && segment < best.segment)) {
                             least = rim;
                             best.segment = segment;
                             best.t = t;
                             best.distanceMm = distance;
                           }
                         });
    const auto [c, i] = owner_[static_cast<std::size_t>(best.segment)];
    const auto& points = curves_[c].points;
    best.point =
        (1.0 - best.t) * points[i].position + best.t * points[(i + 1) % points.size()].position;
    return best;
  }

  const std::vector<SurfaceCurve>& curves_;
  double reach_;
  std::vector<std::array<double, 2>> extra_; // of a segment's ends; empty: none anywhere
  double mostExtra_ = 0.0;
  Cells cells_;
  std::vector<SegmentGrid::Segment> segments_;
  std::vector<std::pair<std::size_t, std::size_t>> owner_; // of a segment: curve, its place there
  std::optional<SegmentGrid> grid_;                        // once it is asked
  int last_ = -1;
};

} // namespace

Cells shareOut(const PatchSurface& s, const std::vector<SurfaceCurve>& curves, double reachMm,
               double sampleMm2, const std::vector<std::vector<double>>& extraMm) {
  base::require(extraMm.empty() || extraMm.size() == curves.size(), "shareOut: extras per curve");
  Sharer sharer(curves, reachMm, extraMm);
  forEachSample(s, sampleMm2, [&](const SurfaceSample& sample) {
    sharer.add(sample, s.triangleNormal[sample.triangle]);
  });
  return sharer.finish();
}

Cells shareOut(const PlaneSamples& samples, const std::vector<SurfaceCurve>& curves, double reachMm,
               const std::vector<std::vector<double>>& extraMm) {
  base::require(extraMm.empty() || extraMm.size() == curves.size(), "shareOut: extras per curve");
  Sharer sharer(curves, reachMm, extraMm);
  sharer.add(samples);
  return sharer.finish();
}

} // namespace voluta::toolpath
