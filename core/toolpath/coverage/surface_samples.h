// Samples of a surface that each represent a small area.
#pragma once

#include "toolpath/patch_surface.h"

#include <Eigen/Core>
#include <cstddef>

namespace voluta::toolpath {

struct SurfaceSample {
  Eigen::Vector3d position;
  double thicknessMm, areaMm2;
  std::size_t triangle;
};

namespace detail {
struct SampleCorner {
  Eigen::Vector3d position;
  double thicknessMm;
};
inline SampleCorner between(const SampleCorner& a, const SampleCorner& b) {
  return {0.5 * (a.position + b.position), 0.5 * (a.thicknessMm + b.thicknessMm)};
}
template <typename F>
void sampleTriangle(const SampleCorner& a, const SampleCorner& b, const SampleCorner& c,
                    double area, double maxMm2, std::size_t triangle, F&& f) {
  if (area > maxMm2) {
    const SampleCorner ab = between(a, b), bc = between(b, c), ca = between(c, a);
    sampleTriangle(ab, bc, ca, area / 4, maxMm2, triangle, f);
    sampleTriangle(a, ab, ca, area / 4, maxMm2, triangle, f);
    sampleTriangle(ab, b, bc, area / 4, maxMm2, triangle, f);
    sampleTriangle(ca, bc, c, area / 4, maxMm2, triangle, f);
    return;
  }
  f(SurfaceSample{(a.position + b.position + c.position) / 3,
                  (a.thicknessMm + b.thicknessMm + c.thicknessMm) / 3, area, triangle});
}
} // namespace detail

// Calls f with the centroids of the surface's triangles, in order. Each triangle is split into four
// until no part is larger than `maxMm2` > 0.
template <typename F> void forEachSample(const PatchSurface& s, double maxMm2, F&& f) {
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) {
      const auto v = static_cast<std::size_t>(s.triangles[t][k]);
      return detail::SampleCorner{s.position[v], s.thicknessMm[v]};
    };
    detail::sampleTriangle(corner(0), corner(1), corner(2), s.triangleArea[t], maxMm2, t, f);
  }
}

} // namespace voluta::toolpath
