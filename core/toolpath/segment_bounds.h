// The box about what is near a segment.
#pragma once

#include <Eigen/Core>

namespace voluta::toolpath {

// How far points may lie beyond a segment's ends, mm: before a, and after b.
struct BeyondEnds {
  double beforeMm = 0.0, afterMm = 0.0;
};

template <int N> struct BoundsAround { Eigen::Matrix<double, N, 1> low, high; };
using SegmentBounds = BoundsAround<3>;

// Of the points up to `radiusMm` from the segment a b that lie no further beyond its ends than
// `beyond` says.
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
  const Vector aside =
      radiusMm * (1.0 - unit.array().square()).max(0.0).sqrt().matrix(); // of a disc across it
  box.low = box.low.cwiseMax(first.cwiseMin(last) - aside);
  box.high = box.high.cwiseMin(first.cwiseMax(last) + aside);
  return box;
}

} // namespace voluta::toolpath
