// Samples of a plane surface that each represent the same area.
#pragma once

#include "toolpath/coverage/near_segment.h"
#include "toolpath/coverage/surface_samples.h"
#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::toolpath {

// One point per cell of a square raster, at a pseudo-random position in the cell so that rows of
// points cannot align with lines (stratified sampling). Where a strip's two rims cross a cell, the
// error is at most one cell. As the raster locates the points, segments can paint them directly,
// whereas samples of other surfaces need a search.
class PlaneSamples {
public:
  // Points represent `sampleMm2` > 0 each. Returns nullopt if the surface is not plane, contains no
  // point, or would need too much memory. `leftOut`: per triangle, whether its points count as
  // outside; empty: none.
  static std::optional<PlaneSamples> of(const PatchSurface& surface, double sampleMm2,
                                        const std::vector<char>& leftOut = {});

  // Number of raster cells, including those outside the surface.
  std::size_t count() const { return triangle_.size(); }
  bool isInside(std::size_t cell) const { return triangle_[cell] >= 0; }
  double areaMm2() const { return areaMm2_; } // Area represented by one point
  const Eigen::Vector3d& normal(std::size_t) const { return normal_; }
  // Precondition: isInside(cell).
  SurfaceSample sample(std::size_t cell) const;

  // Calls f(cell, squared distance, parameter on the segment) for points up to `radiusMm` from the
  // segment a b of the plane, including points outside the surface, in float precision. May omit
  // points that exceed the segment's ends by more than `beyond`.
  template <typename F>
  void forEachNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                   const BeyondEnds& beyond, F&& f) const {
    forFoursNear(a, b, radiusMm, beyond,
                 eachOfFour(static_cast<float>(radiusMm * radiusMm), std::forward<F>(f)));
  }

  // The same in groups of four, which may include other points: f(first cell, squared distances,
  // parameters).
  template <typename F>
  void forFoursNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                    const BeyondEnds& beyond, F&& f) const {
    const Eigen::Vector2d from = flat(a), to = flat(b);
    const auto bounds = boundsAround(from, to, radiusMm, beyond);
    const FloatSegment<2> segment(from, to);
    const auto cells = [&](int k, int& first, int& last) {
      first = std::max(0, static_cast<int>(std::floor(bounds.low[k] / pitch_)));
      last = std::min(size_[k] - 1, static_cast<int>(std::floor(bounds.high[k] / pitch_)));
    };
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    cells(0, x0, x1);
    cells(1, y0, y1);
    for (int y = y0; y <= y1 && x0 <= x1; ++y) {
      const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x());
      forFours<2>(segment, {x_.data(), y_.data()}, row + static_cast<std::size_t>(x0),
                  row + static_cast<std::size_t>(x1) + 1, f);
    }
  }

private:
  Eigen::Vector2d flat(const Eigen::Vector3d& p) const {
    return {across_.dot(p) - low_.x(), up_.dot(p) - low_.y()};
  }
  void paint(const PatchSurface& surface, const std::vector<char>& leftOut);

  Eigen::Vector3d normal_, across_, up_;                // Orthonormal
  double offsetMm_ = 0.0, pitch_ = 0.0, areaMm2_ = 0.0; // areaMm2_: area represented by one point
  Eigen::Vector2d low_;
  Eigen::Vector2i size_;
  // Positions of the points in the plane, relative to low_; padded by kLanes - 1
  std::vector<float> x_, y_;
  std::vector<int> triangle_; // -1: outside
  std::vector<float> thicknessMm_;
};

} // namespace voluta::toolpath
