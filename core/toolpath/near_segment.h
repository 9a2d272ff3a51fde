// What is near a segment: how near, and the box about it.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace voluta::toolpath {

// A segment to the precision of a float, for many points.
template <int N> class FloatSegment {
public:
  using Vector = Eigen::Matrix<float, N, 1>;
  FloatSegment(const Eigen::Matrix<double, N, 1>& a, const Eigen::Matrix<double, N, 1>& b)
      : from_(a.template cast<float>()), along_((b - a).template cast<float>()) {
    const float squared = along_.squaredNorm();
    inverse_ = squared > 0.0F ? 1.0F / squared : 0.0F;
  }
  struct Nearest {
    float t, squared; // 0 at a, 1 at b; of the distance
  };
  Nearest nearest(const Vector& p) const {
    const Vector off = p - from_;
    const float t = std::clamp(along_.dot(off) * inverse_, 0.0F, 1.0F);
    return {t, (off - t * along_).squaredNorm()};
  }

private:
  Vector from_, along_;
  float inverse_; // of the squared length
};

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
