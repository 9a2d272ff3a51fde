#include "pipeline/replayed/apart.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace voluta::pipeline {

namespace {

using Eigen::Vector3d;

// Enlarges `maximum` to the largest distance of a motion's samples from the path of the same motion
// in another run.
void stretch(Apart& maximum, const replay::ExecutedPath& path, std::size_t motion,
             const replay::ExecutedPath& other, std::size_t same, double reachMm) {
  const std::size_t begin = other.firstSample[same], end = other.firstSample[same + 1];
  for (std::size_t s = path.firstSample[motion]; s < path.firstSample[motion + 1]; ++s) {
    double nearest = INFINITY;
    Vector3d tip = other.tip[begin], direction = other.direction[begin];
    for (std::size_t k = std::max<std::size_t>(begin, 1); k < end; ++k) {
      const Vector3d ab = other.tip[k] - other.tip[k - 1];
      const double squared = ab.squaredNorm();
      const double t = squared > 0.0
                           ? std::clamp(ab.dot(path.tip[s] - other.tip[k - 1]) / squared, 0.0, 1.0)
                           : 1.0;
      const Vector3d q = other.tip[k - 1] + t * ab;
      if (const double d = (q - path.tip[s]).squaredNorm(); d < nearest) {
        nearest = d;
        tip = q;
        direction = (1.0 - t) * other.direction[k - 1] + t * other.direction[k];
      }
    }
    const Vector3d off = path.tip[s] - tip;
    maximum.tipMm = std::max(maximum.tipMm, off.norm());
    maximum.headMm = std::max(
        maximum.headMm, (off + reachMm * (path.direction[s] - direction.normalized())).norm());
  }
}

} // namespace

std::vector<Apart> apart(const replay::Run& a, const replay::Run& b, double reachMm,
                         const base::RunContext& ctx) {
  std::size_t points = 0;
  for (const std::size_t point : a.commonPoint)
    if (point != replay::kUnmatched)
      points = std::max(points, point + 1);
  std::vector<std::size_t> motionTo(points, replay::kUnmatched);
  for (std::size_t m = 0; m < a.commonPoint.size(); ++m)
    if (a.commonPoint[m] != replay::kUnmatched)
      motionTo[a.commonPoint[m]] = m;
  std::vector<Apart> result(b.path.motionCount());
  base::parallelChunks(ctx, result.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end && !ctx.cancelled(); ++m) {
      const std::size_t same =
          b.commonPoint[m] < points ? motionTo[b.commonPoint[m]] : replay::kUnmatched;
      if (same == replay::kUnmatched)
        continue;
      result[m].motion = same;
      stretch(result[m], a.path, same, b.path, m, reachMm);
      stretch(result[m], b.path, m, a.path, same, reachMm);
    }
  });
  ctx.checkpoint();
  return result;
}

} // namespace voluta::pipeline
