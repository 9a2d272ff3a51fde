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

// Of the reach: what is nearer to the curves is painted by them, the rest looks for its own.
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

  template <typename Samples> void add(const Samples& samples) {
    const std::vector<int> near = painted(samples);
    for (std::size_t cell = 0; cell < samples.count(); ++cell) {
      if (!samples.isInside(cell))
        continue;
      const SurfaceSample sample = samples.sample(cell);
      give(sample, samples.normal(cell), near[cell] >= 0 ? near[cell] : nearest(sample.position));
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
  template <typename Samples> std::vector<int> painted(const Samples& samples) const {
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
        samples.forEachNear(a, b, near, beyond(i, near),
                            [&](std::size_t cell, float squared, float) { offer(cell, squared); });
        continue;
      }
      const auto from = static_cast<float>(extra_[i][0]), to = static_cast<float>(extra_[i][1]);
      const double radius = std::min(reach_, near + std::max(extra_[i][0], extra_[i][1]));
      samples.forEachNear(a, b, radius, {radius, radius},
                          [&](std::size_t cell, float squared, float t) {
                            offer(cell, std::sqrt(squared) - (from + t * (to - from)));
                          });
    }
    return nearest;
  }

  // What lies further beyond an end at which another segment goes on is nearer to that one.
  BeyondEnds beyond(std::size_t segment, double nearMm) const {
    constexpr double kSlackMm = 1e-3;
    const Place& place = places_[segment];
    const std::size_t first = segment - place.segment,
                      count = cells_.share[place.curve].areaMm2.size();
    const auto past = [&](bool isEnd, std::size_t other) {
      const Eigen::Vector3d& next = places_[first + other % count].along;
      if (isEnd || place.along.dot(next) <= 0.0)
        return nearMm;
      // On the outside of the bend, what is nearest to the corner itself.
      return kSlackMm + nearMm * place.along.cross(next).norm();
    };
    return {past(place.isFirst, place.segment + count - 1), past(place.isLast, place.segment + 1)};
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

namespace {
template <typename Samples>
Cells shared(const Samples& samples, const std::vector<SurfaceCurve>& curves, double reachMm,
             const std::vector<std::vector<double>>& extraMm) {
  base::require(extraMm.empty() || extraMm.size() == curves.size(), "shareOut: extras per curve");
  Sharer sharer(curves, reachMm, extraMm);
  sharer.add(samples);
  return sharer.finish();
}
} // namespace

Cells shareOut(const SampleGrid& samples, const std::vector<SurfaceCurve>& curves, double reachMm,
               const std::vector<std::vector<double>>& extraMm) {
  return shared(samples, curves, reachMm, extraMm);
}

Cells shareOut(const PlaneSamples& samples, const std::vector<SurfaceCurve>& curves, double reachMm,
               const std::vector<std::vector<double>>& extraMm) {
  return shared(samples, curves, reachMm, extraMm);
}

} // namespace voluta::toolpath
