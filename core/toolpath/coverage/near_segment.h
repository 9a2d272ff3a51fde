// Distances from points to a segment, and the bounding box of the points near a segment.
#pragma once

#include "base/lanes.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace voluta::toolpath {

using base::Floats;
using base::Ints;
// Points processed at a time.
inline constexpr std::size_t kLanes = base::kLanes;

// A segment in float precision, for measuring many points.
template <int N> class FloatSegment {
public:
  FloatSegment(const Eigen::Matrix<double, N, 1>& a, const Eigen::Matrix<double, N, 1>& b)
      : from_(a.template cast<float>()), along_((b - a).template cast<float>()) {
    const float squared = along_.squaredNorm();
    inverse_ = squared > 0.0F ? 1.0F / squared : 0.0F;
  }
  struct Nearest {
    Floats t, squared; // Parameter on the segment (0 at a, 1 at b), and squared distance
  };
  // Computes the nearest points for kLanes points. `points`: one array of coordinates per axis.
  Nearest nearest(const std::array<const float*, N>& points) const {
    std::array<Floats, N> off;
    Floats along{}, squared{};
    for (int k = N; k-- > 0;) {
      const auto axis = static_cast<std::size_t>(k);
      off[axis] = base::load<Floats>(points[axis]) - from_[k];
      along += along_[k] * off[axis];
    }
    const Floats raw = along * inverse_, positive = raw < 0.0F ? Floats{} : raw,
                 t = positive > 1.0F ? Floats{} + 1.0F : positive;
    for (int k = N; k-- > 0;) {
      const Floats lateral = off[static_cast<std::size_t>(k)] - t * along_[k];
      squared += lateral * lateral;
    }
    return {t, squared};
  }

private:
  Eigen::Matrix<float, N, 1> from_, along_;
  float inverse_; // 1 / squared length
};

// Calls f(first, squared distances, parameters) for groups of four of the points first to end - 1;
// points past the end are infinitely far. The coordinate arrays must extend kLanes - 1 beyond the
// end.
template <int N, typename F>
void forFours(const FloatSegment<N>& segment, const std::array<const float*, N>& points,
              std::size_t first, std::size_t end, F&& f) {
  for (std::size_t i = first; i < end; i += kLanes) {
    std::array<const float*, N> four = points;
    for (const float*& p : four)
      p += i;
    auto [t, squared] = segment.nearest(four);
    for (std::size_t lane = std::min(end - i, kLanes); lane < kLanes; ++lane)
      squared[lane] = std::numeric_limits<float>::infinity();
    f(i, squared, t);
  }
}

// Returns a callback for forFours() that calls f(point, squared distance, parameter) for each point
// with a squared distance up to `maxSquared`.
template <typename F> auto eachOfFour(float maxSquared, F&& f) {
  return [maxSquared, &f](std::size_t first, const Floats& squared, const Floats& t) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      if (squared[lane] <= maxSquared)
        f(first + lane, squared[lane], t[lane]);
  };
}

// How far [mm] points may be beyond a segment's ends: before a, and after b.
struct BeyondEnds {
  double beforeMm = 0.0, afterMm = 0.0;
};

template <int N> struct BoundsAround { Eigen::Matrix<double, N, 1> low, high; };
using SegmentBounds = BoundsAround<3>;

// Returns the bounding box of the points up to `radiusMm` from the segment a b that exceed its ends
// by at most `beyond`.
template <int N>
BoundsAround<N> boundsAround(const Eigen::Matrix<double, N, 1>& a,
                             const Eigen::Matrix<double, N, 1>& b, double radiusMm,
                             const BeyondEnds& beyond) {
  using Vector = Eigen::Matrix<double, N, 1>;
  const Vector radius = Vector::Constant(radiusMm);
  BoundsAround<N> box{a.cwiseMin(b) - radius, a.cwiseMax(b) + radius};
  const double length = (b - a).norm();
  if (!(length > 1e-9))
    return box;
  const Vector unit = (b - a) / length;
  const Vector first = a - beyond.beforeMm * unit, last = b + beyond.afterMm * unit;
  const Vector lateral =
      // Half extents of a disc perpendicular to the segment
      radiusMm * (1.0 - unit.array().square()).max(0.0).sqrt().matrix();
  box.low = box.low.cwiseMax(first.cwiseMin(last) - lateral);
  box.high = box.high.cwiseMin(first.cwiseMax(last) + lateral);
  return box;
}

} // namespace voluta::toolpath
