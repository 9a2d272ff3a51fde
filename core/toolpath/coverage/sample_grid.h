// The samples of a surface in a grid, for finding those near a segment.
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

// Square bins in rows perpendicular to the axis that the surface mostly faces. The samples of a bin
// are contiguous in memory, and so are those of a row of bins.
class SampleGrid {
public:
  // Holds the samples of forEachSample() (surface_samples.h). `surface` must outlive this object.
  SampleGrid(const PatchSurface& surface, double maxMm2);

  std::size_t count() const { return samples_.size(); }
  bool isInside(std::size_t) const { return true; }
  const SurfaceSample& sample(std::size_t i) const { return samples_[i]; }
  const Eigen::Vector3d& normal(std::size_t i) const {
    return surface_.triangleNormal[samples_[i].triangle];
  }

  // Calls f(sample, squared distance, parameter on the segment) for samples up to `radiusMm` from
  // the segment a b, in float precision. May omit samples that exceed the segment's ends by more
  // than `beyond`.
  template <typename F>
  void forEachNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                   const BeyondEnds& beyond, F&& f) const {
    forFoursNear(a, b, radiusMm, beyond,
                 eachOfFour(static_cast<float>(radiusMm * radiusMm), std::forward<F>(f)));
  }

  // The same in groups of four, which may include other samples: f(first sample, squared distances,
  // parameters).
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
  std::array<Eigen::Index, 2> axes_{0, 1}; // Along the rows, and across them
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double bin_ = 1.0; // Edge length [mm]
  std::array<int, 2> size_{1, 1};
  std::vector<std::uint32_t> begin_; // Index of each bin's first sample; one more entry at the end
  std::vector<SurfaceSample> samples_; // Sorted by bin
  // Coordinates of the samples relative to origin_; padded by kLanes - 1
  std::array<std::vector<float>, 3> point_;
};

} // namespace voluta::toolpath
