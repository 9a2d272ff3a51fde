// The samples of a surface by where they are, so that what lies near a segment is found at once.
#pragma once

#include "toolpath/coverage/near_segment.h"
#include "toolpath/coverage/surface_samples.h"
#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace voluta::toolpath {

// Rows of square bins across the axis that the surface faces most; samples of a bin lie side by
// side, those of a row of bins too.
class SampleGrid {
public:
  // The samples of forEachSample() (surface_samples.h). `surface` outlives it.
  SampleGrid(const PatchSurface& surface, double mostMm2);

  std::size_t count() const { return samples_.size(); }
  bool isInside(std::size_t) const { return true; }
  const SurfaceSample& sample(std::size_t i) const { return samples_[i]; }
  const Eigen::Vector3d& normal(std::size_t i) const {
    return surface_.triangleNormal[samples_[i].triangle];
  }

  // Calls f(sample, squared distance, where on it) for samples up to `radiusMm` from the segment
  // a b, to the precision of a float. Of those that lie further beyond its ends than `beyond` says
  // it may leave out any.
  template <typename F>
  void forEachNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                   const BeyondEnds& beyond, F&& f) const {
    forFoursNear(a, b, radiusMm, beyond,
                 eachOfFour(static_cast<float>(radiusMm * radiusMm), std::forward<F>(f)));
  }

  // The same for these and others, by fours: f(first sample, squared distances, where on it).
  template <typename F>
  void forFoursNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                    const BeyondEnds& beyond, F&& f) const {
    const SegmentBounds bounds = boundsAround(a, b, radiusMm, beyond);
    const FloatSegment<3> segment(a - origin_, b - origin_);
    std::array<int, 2> from{}, to{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Eigen::Index axis = axes_[k];
      const double low = (bounds.low[axis] - origin_[axis]) / bin_;
      const double high = (bounds.high[axis] - origin_[axis]) / bin_;
      if (high < 0.0)
        return;
      from[k] = static_cast<int>(std::max(0.0, low));
      to[k] = static_cast<int>(std::min(high, size_[k] - 1.0));
      if (to[k] < from[k])
        return;
    }
    for (int row = from[1]; row <= to[1]; ++row)
      forFours<3>(segment, {point_[0].data(), point_[1].data(), point_[2].data()},
                  begin_[binAt(from[0], row)], begin_[binAt(to[0], row) + 1], f);
  }

private:
  std::size_t binAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(column);
  }

  const PatchSurface& surface_;
  std::array<Eigen::Index, 2> axes_{0, 1}; // along rows, and across them
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double bin_ = 1.0; // mm
  std::array<int, 2> size_{1, 1};
  std::vector<std::uint32_t> begin_;        // of a bin's samples; one more
  std::vector<SurfaceSample> samples_;      // by bins
  std::array<std::vector<float>, 3> point_; // of these, from origin_; kLanes - 1 more
};

} // namespace voluta::toolpath
