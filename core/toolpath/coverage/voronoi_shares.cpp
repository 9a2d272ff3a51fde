#include "toolpath/coverage/voronoi_shares.h"

#include "base/error.h"
#include "toolpath/coverage/segment_grid.h"
#include "toolpath/coverage/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {

// Share of the reach: samples nearer than this to a curve are painted by its segments; the others
// search for their nearest segment.
constexpr double kPainted = 0.4;

// Assigns the samples of a surface to the nearest segment of the curves.
class Sharer {
public:
  Sharer(const std::vector<SurfaceCurve>& curves, double reachMm,
         const std::vector<std::vector<double>>& extraMm, const UniformStretches& even)
      : reach_(reachMm), even_(even) {
    cells_.share.resize(curves.size());
    double steepest = 0.0; // Maximum change of `extra` along a segment
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto& points = curves[c].points;
      const std::size_t n = points.size() - (curves[c].closed ? 0 : 1);
      begin_.push_back(segments_.size());
      for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d& a = points[i].position;
        const Eigen::Vector3d& b = points[(i + 1) % points.size()].position;
        segments_.push_back({a, b});
        const double length = (b - a).norm();
        places_.push_back({c, !curves[c].closed && i == 0,
                           !curves[c].closed && i + 2 == points.size(),
                           length > 1e-9 ? ((b - a) / length).eval() : Eigen::Vector3d::Zero()});
        if (!extraMm.empty()) {
          const std::vector<double>& extra = extraMm[c];
          extra_.push_back(extra.empty() ? std::array{0.0, 0.0}
                                         : std::array{extra[i], extra[(i + 1) % points.size()]});
          const auto& [from, to] = extra_.back();
          maxExtra_ = std::max({maxExtra_, from, to});
          steepest = std::max(steepest, length > 1e-9 ? std::abs(to - from) / length : 0.0);
        }
      }
    }
    begin_.push_back(segments_.size());
    tallies_.resize(segments_.size());
    taper_ = steepest < 0.4 ? 2.0 * steepest / (1.0 - steepest * steepest) : 1.0;
  }

  template <typename Samples> void add(const Samples& samples) {
    const std::vector<std::int32_t> near = painted(samples);
    for (std::size_t cell = 0; cell < samples.count(); ++cell) {
      if (!samples.isInside(cell))
        continue;
      const SurfaceSample sample = samples.sample(cell);
      if (!even_.triangles.empty() && even_.triangles[sample.triangle])
        continue;
      give(sample, samples.normal(cell), near[cell] >= 0 ? near[cell] : nearest(sample.position));
    }
  }

  VoronoiShares finish() {
    for (std::size_t c = 0; c < cells_.share.size(); ++c) {
      CellShare& share = cells_.share[c];
      for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i) {
        const EvenSegment* even = evenOf(c, i - begin_[c]);
        const Tally tally =
            even ? Tally{even->areaMm2, even->volumeMm3, 0.0, 0.5 * even->areaMm2} : tallies_[i];
        share.areaMm2.push_back(tally.areaMm2);
        share.leftMm2.push_back(tally.leftMm2);
        share.volumeMm3.push_back(tally.volumeMm3);
        share.lateralMm.push_back(tally.areaMm2 > 0 ? tally.lateral / tally.areaMm2 : 0.0);
      }
    }
    return std::move(cells_);
  }

private:
  // Returns the even segment; nullptr if its share is computed from samples.
  const EvenSegment* evenOf(std::size_t curve, std::size_t segment) const {
    if (even_.segments.empty() || even_.segments[curve].empty())
      return nullptr;
    const EvenSegment& even = even_.segments[curve][segment];
    return even.areaMm2 > 0.0 ? &even : nullptr;
  }

  void give(const SurfaceSample& sample, const Eigen::Vector3d& normal, int segment) {
    const double area = sample.areaMm2;
    if (segment < 0) {
      cells_.orphanMm2 += area;
      return;
    }
    const Place& place = places_[static_cast<std::size_t>(segment)];
    const auto& [a, b] = segments_[static_cast<std::size_t>(segment)];
    const Eigen::Vector3d off = sample.position - a;
    Tally& tally = tallies_[static_cast<std::size_t>(segment)];
    tally.areaMm2 += area;
    tally.volumeMm3 += area * sample.thicknessMm;
    const double lateral = normal.cross(place.along).dot(off);
    tally.lateral += area * lateral;
    if (lateral > 0.0)
      tally.leftMm2 += area;
    if (place.isFirst && place.along.dot(off) <= 0.0)
      cells_.share[place.curve].beyondMm2[0] += area;
    else if (place.isLast && place.along.dot(sample.position - b) >= 0.0)
      cells_.share[place.curve].beyondMm2[1] += area;
  }

  // Returns -1 if no segment is within reach.
  int nearest(const Eigen::Vector3d& p) {
    if (!grid_)
      grid_.emplace(segments_, reach_);
    const SegmentGrid::Hit hit = grid_->nearest(p, last_);
    last_ = hit.segment;
    return hit.segment >= 0 && maxExtra_ > 0.0 ? nearestOfWide(p, hit) : hit.segment;
  }

  // Returns per cell the result of nearest() if it is so near that no segment other than those that
  // paint the cell can be nearer; else -1.
  template <typename Samples> std::vector<std::int32_t> painted(const Samples& samples) const {
    const double near = kPainted * reach_;
    // A group of four may begin at the last sample
    const std::size_t count = samples.count() + kLanes - 1;
    std::vector<std::int32_t> nearest(count, -1);
    std::vector<float> minimum(count, static_cast<float>(extra_.empty() ? near * near : near));
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto& [a, b] = segments_[i];
      const std::size_t curve = places_[i].curve;
      if (const EvenSegment* even = evenOf(curve, i - begin_[curve]); even && even->clearMm > near)
        continue;
      const auto offer = [&](std::size_t first, const Floats& distance) {
        const auto before = base::load<Floats>(&minimum[first]);
        const Ints isNearer = distance < before;
        base::store<Floats>(isNearer ? distance : before, &minimum[first]);
        base::store<Ints>(isNearer ? Ints{} + static_cast<std::int32_t>(i)
                                   : base::load<Ints>(&nearest[first]),
                          &nearest[first]);
      };
      if (extra_.empty()) {
        samples.forFoursNear(a, b, near, beyond(i, near),
                             [&](std::size_t first, const Floats& squared, const Floats&) {
                               offer(first, squared);
                             });
        continue;
      }
      const auto from = static_cast<float>(extra_[i][0]), to = static_cast<float>(extra_[i][1]);
      const double radius = std::min(reach_, near + std::max(extra_[i][0], extra_[i][1]));
      samples.forFoursNear(a, b, radius, beyond(i, radius),
                           [&](std::size_t first, const Floats& squared, const Floats& t) {
                             Floats distance{};
                             for (std::size_t lane = 0; lane < kLanes; ++lane)
                               distance[lane] = std::sqrt(squared[lane]);
                             offer(first, distance - (from + t * (to - from)));
                           });
    }
    return nearest;
  }

  // Samples beyond an end at which another segment continues are nearer to that segment.
  BeyondEnds beyond(std::size_t segment, double nearMm) const {
    constexpr double kSlackMm = 1e-3;
    const Place& place = places_[segment];
    const std::size_t first = begin_[place.curve], count = begin_[place.curve + 1] - first;
    const auto past = [&](bool isEnd, std::size_t other) {
      const Eigen::Vector3d& next = places_[first + (segment + other - first) % count].along;
      if (isEnd || place.along.dot(next) <= 0.0)
        return nearMm;
      // On the outside of the bend, include the samples nearest to the corner itself.
      return kSlackMm + nearMm * (place.along.cross(next).norm() + taper_);
    };
    return {past(place.isFirst, count - 1), past(place.isLast, 1)};
  }

  double extraAt(int segment, double t) const {
    const auto& [from, to] = extra_[static_cast<std::size_t>(segment)];
    return (1.0 - t) * from + t * to;
  }

  // Returns the segment whose bead edge is nearest, among those whose extra width may take the
  // sample from `nearest`.
  int nearestOfWide(const Eigen::Vector3d& p, const SegmentGrid::Hit& nearest) const {
    int best = nearest.segment;
    double minimum = nearest.distanceMm - extraAt(nearest.segment, nearest.t);
    grid_->forEachWithin(p, std::min(reach_, minimum + maxExtra_),
                         [&](int segment, double t, double distance) {
                           const double rim = distance - extraAt(segment, t);
                           if (rim < minimum || (rim == minimum && segment < best)) {
                             minimum = rim;
                             best = segment;
                           }
                         });
    return best;
  }

  struct Place { // A segment's position in its curve
    std::size_t curve;
    bool isFirst, isLast;  // The segment is the first or last one of an open curve
    Eigen::Vector3d along; // Unit vector; zero if the segment has no length
  };
  struct Tally {                                          // Sums over the samples of a segment
    double areaMm2 = 0.0, volumeMm3 = 0.0, lateral = 0.0; // lateral: [mm] times [mm2]
    double leftMm2 = 0.0;
  };
  double reach_;
  const UniformStretches& even_;
  std::vector<std::array<double, 2>> extra_; // At both ends of each segment; empty: none
  double maxExtra_ = 0.0;
  // Share of a distance: how far beyond its end a wide segment may be nearer than the narrower one
  // that continues it.
  double taper_ = 0.0;
  VoronoiShares cells_;
  std::vector<std::size_t> begin_; // Index of each curve's first segment; one more entry at the end
  std::vector<SegmentGrid::Segment> segments_;
  std::vector<Place> places_;
  std::vector<Tally> tallies_;
  std::optional<SegmentGrid> grid_; // Made on first use
  int last_ = -1;
};

} // namespace

namespace {
template <typename Samples>
VoronoiShares computeShares(const Samples& samples, const std::vector<SurfaceCurve>& curves,
                            double reachMm, const std::vector<std::vector<double>>& extraMm,
                            const UniformStretches& even) {
  base::require(extraMm.empty() || extraMm.size() == curves.size(), "shareOut: extras per curve");
  base::require(even.segments.empty() || even.segments.size() == curves.size(),
                "shareOut: even segments per curve");
  Sharer sharer(curves, reachMm, extraMm, even);
  sharer.add(samples);
  return sharer.finish();
}
} // namespace

VoronoiShares assignToNearestCurve(const SampleGrid& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm) {
  return computeShares(samples, curves, reachMm, extraMm, {});
}

VoronoiShares assignToNearestCurve(const PlaneSamples& samples,
                                   const std::vector<SurfaceCurve>& curves, double reachMm,
                                   const std::vector<std::vector<double>>& extraMm,
                                   const UniformStretches& even) {
  return computeShares(samples, curves, reachMm, extraMm, even);
}

} // namespace voluta::toolpath
