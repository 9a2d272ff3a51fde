#include "toolpath/coverage/uniform_interior.h"

#include "base/error.h"
#include "base/index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;

constexpr double kSteepest = 1.1; // Maximum slope of the depth [hatches per hatch]
// Share of the line spacing: a line's share never extends further to its side.
constexpr double kOwn = 0.6;
} // namespace

double evenFrom(const std::vector<double>& uniformSpacingMm, const std::vector<double>& depth) {
  double from = INFINITY;
  for (std::size_t v = 0; v < uniformSpacingMm.size(); ++v)
    from = uniformSpacingMm[v] > 0.0 ? std::min(from, depth[v]) : from;
  return from;
}

UniformInterior::UniformInterior(const PatchSurface& surface, std::vector<double> uniformSpacingMm,
                                 const std::vector<double>& depth, double hatchMm, double longestMm)
    : s_(surface), uniformSpacingMm_(std::move(uniformSpacingMm)) {
  base::require(uniformSpacingMm_.empty() || uniformSpacingMm_.size() == surface.position.size(),
                "even lines: a spacing per vertex");
  if (std::ranges::none_of(uniformSpacingMm_, [](double mm) { return mm > 0.0; })) {
    uniformSpacingMm_.clear();
    return;
  }
  base::require(depth.size() == uniformSpacingMm_.size() && hatchMm > 0.0,
                "even lines: a depth per vertex");
  const double edge = evenFrom(uniformSpacingMm_, depth),
               widest = std::ranges::max(uniformSpacingMm_);
  // A sample assigned to a line is so close to it that it is in the even interior too.
  const double inside = edge + kSteepest * (kOwn * widest + longestMm) / hatchMm;
  const auto corners = [&](std::size_t t, auto&& f) {
    for (const int v : s_.triangles[t])
      f(at(v));
  };
  triangles_.assign(s_.triangles.size(), 0);
  clearMm_.assign(s_.triangles.size(), -1.0);
  double deepest = edge; // Depth of the samples that are still evaluated
  for (std::size_t t = 0; t < s_.triangles.size(); ++t) {
    bool any = false, all = true;
    double maximum = 0.0;
    corners(t, [&](std::size_t v) {
      any = any || uniformSpacingMm_[v] > 0.0;
      all = all && uniformSpacingMm_[v] > 0.0 && depth[v] >= inside;
      maximum = std::max(maximum, depth[v]);
    });
    triangles_[t] = all;
    if (any && !all)
      deepest = std::max(deepest, maximum);
  }
  for (std::size_t t = 0; t < s_.triangles.size(); ++t) {
    double minimum = INFINITY;
    corners(t, [&](std::size_t v) {
      minimum = std::min(minimum, uniformSpacingMm_[v] > 0.0 ? depth[v] : -INFINITY);
    });
    if (minimum > -INFINITY)
      clearMm_[t] = std::max(0.0, (minimum - deepest) * hatchMm / kSteepest - 0.5 * longestMm);
  }
}

std::vector<EvenSegment> UniformInterior::along(const SurfaceCurve& curve) const {
  const std::size_t n = curve.points.size(), count = curve.closed ? n : n - 1;
  const auto isEven = [&](const SurfacePoint& p) { return clearMm_[at(p.triangle)] >= 0.0; };
  std::vector<EvenSegment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    if (!isEven(p) || !isEven(q))
      continue;
    segments.resize(count);
    const double spacing = uniformSpacingMm_[at(s_.triangles[at(p.triangle)][0])];
    const double area = spacing * (q.position - p.position).norm();
    const double thickness =
        0.5 * (s_.interpolate(s_.thicknessMm, p) + s_.interpolate(s_.thicknessMm, q));
    segments[i] = {area, area * thickness,
                   std::min(clearMm_[at(p.triangle)], clearMm_[at(q.triangle)])};
  }
  return segments;
}

UniformStretches UniformInterior::of(const std::vector<SurfaceCurve>& curves) const {
  UniformStretches even;
  if (uniformSpacingMm_.empty())
    return even;
  even.triangles = triangles_;
  for (const SurfaceCurve& c : curves)
    even.segments.push_back(along(c));
  return even;
}

} // namespace voluta::toolpath
