// A plane surface as points that each stand for the same bit of its area.
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

// One point in each cell of a square raster, anywhere in it, so that no lines run along with rows
// of points: known by where they are, they are painted, where points of other surfaces have to be
// looked for. Stratified sampling: of what a strip's two rims cross, a cell errs by no more than
// itself.
class PlaneSamples {
public:
  // Points stand for `sampleMm2` > 0 each. Nothing where the surface is not plane, or holds no
  // point or more than memory does. `leftOut`: per triangle, count its points as outside; empty:
  // none.
  static std::optional<PlaneSamples> of(const PatchSurface& surface, double sampleMm2,
                                        const std::vector<char>& leftOut = {});

  // VoronoiShares of the raster, some of them outside.
  std::size_t count() const { return triangle_.size(); }
  bool isInside(std::size_t cell) const { return triangle_[cell] >= 0; }
  double areaMm2() const { return areaMm2_; } // that a point stands for
  const Eigen::Vector3d& normal(std::size_t) const { return normal_; }
  // Precondition: isInside(cell).
  SurfaceSample sample(std::size_t cell) const;

  // Calls f(cell, squared distance, where on it) for points up to `radiusMm` from the segment a b
  // of the plane, those outside too, to the precision of a float. Of those that lie further beyond
  // its ends than `beyond` says it may leave out any.
  template <typename F>
  void forEachNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radiusMm,
                   const BeyondEnds& beyond, F&& f) const {
    forFoursNear(a, b, radiusMm, beyond,
                 eachOfFour(static_cast<float>(radiusMm * radiusMm), std::forward<F>(f)));
  }

  // The same for these and others, by fours: f(first cell, squared distances, where on it).
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

  Eigen::Vector3d normal_, across_, up_;                // unit, across each other
  double offsetMm_ = 0.0, pitch_ = 0.0, areaMm2_ = 0.0; // areaMm2_: of a point
  Eigen::Vector2d low_;
  Eigen::Vector2i size_;
  std::vector<float> x_, y_;  // of points in the plane, from low_; kLanes - 1 more
  std::vector<int> triangle_; // -1: outside
  std::vector<float> thicknessMm_;
};

} // namespace voluta::toolpath
