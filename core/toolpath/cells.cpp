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
      : reach_(reachMm) {
    cells_.share.resize(curves.size());
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto& points = curves[c].points;
      const std::size_t n = points.size() - (curves[c].closed ? 0 : 1);
      cells_.share[c].areaMm2.assign(n, 0.0);
      cells_.share[c].volumeMm3.assign(n, 0.0);
      cells_.share[c].lateralMm.assign(n, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d& a = points[i].position;
        const Eigen::Vector3d& b = points[(i + 1) % points.size()].position;
        segments_.push_back({a, b});
        const double length = (b - a).norm();
        places_.push_back({c, i, !curves[c].closed && i == 0,
                           !curves[c].closed && i + 2 == points.size(),
                           length > 1e-9 ? ((b - a) / length).eval() : Eigen::Vector3d::Zero()});
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
        give(sample, samples.normal(), nearest[cell]);
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
  void give(const SurfaceSample& sample, const Eigen::Vector3d& normal, int segment) {
    const double area = sample.areaMm2;
    if (segment < 0) {
      cells_.orphanMm2 += area;
      return;
    }
    const Place& place = places_[static_cast<std::size_t>(segment)];
    const auto& [a, b] = segments_[static_cast<std::size_t>(segment)];
    const Eigen::Vector3d off = sample.position - a;
    CellShare& share = cells_.share[place.curve];
    share.areaMm2[place.segment] += area;
    share.volumeMm3[place.segment] += area * sample.thicknessMm;
    share.lateralMm[place.segment] += area * normal.cross(place.along).dot(off);
    if (place.isFirst && place.along.dot(off) <= 0.0)
      share.beyondMm2[0] += area;
    else if (place.isLast && place.along.dot(sample.position - b) >= 0.0)
      share.beyondMm2[1] += area;
  }

  // -1: none in reach.
  int nearest(const Eigen::Vector3d& p) {
    if (!grid_)
      grid_.emplace(segments_, reach_);
    const SegmentGrid::Hit hit = grid_->nearest(p, last_);
    last_ = hit.segment;
    return hit.segment >= 0 && mostExtra_ > 0.0 ? nearestOfWide(p, hit) : hit.segment;
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
  int nearestOfWide(const Eigen::Vector3d& p, const SegmentGrid::Hit& nearest) const {
    int best = nearest.segment;
    double least = nearest.distanceMm - extraAt(nearest.segment, nearest.t);
    grid_->forEachWithin(p, std::min(reach_, least + mostExtra_),
                         [&](int segment, double t, double distance) {
                           const double rim = distance - extraAt(segment, t);
                           if (rim < least || (rim == least && segment < best)) {
                             least = rim;
                             best = segment;
                           }
                         });
    return best;
  }

  struct Place { // of a segment
    std::size_t curve, segment;
    bool isFirst, isLast;  // of an open curve
    Eigen::Vector3d along; // unit; zero: of no length
  };
  double reach_;
  std::vector<std::array<double, 2>> extra_; // of a segment's ends; empty: none anywhere
  double mostExtra_ = 0.0;
  Cells cells_;
  std::vector<SegmentGrid::Segment> segments_;
  std::vector<Place> places_;
  std::optional<SegmentGrid> grid_; // once it is asked
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
