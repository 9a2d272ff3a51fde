#include "planar/published/shape_diameter.h"

#include "base/parallel.h"
#include "geometry/nearest_share.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<double> shapeDiameters(const geometry::TriangleMesh& mesh,
                                   const CurveSkeleton& skeleton, const base::RunContext& ctx) {
  std::vector<double> out(mesh.triangles.size(), 0.0);
  if (skeleton.points.empty())
    return out;
  base::parallelChunks(ctx, out.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Vector3d p = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
      double minimum = 1e300;
      for (const Vector3d& q : skeleton.points)
        minimum = std::min(minimum, (p - q).squaredNorm());
      for (const auto& e : skeleton.edges) {
        const Vector3d& a = skeleton.points[static_cast<std::size_t>(e[0])];
        const Vector3d& b = skeleton.points[static_cast<std::size_t>(e[1])];
        minimum =
            std::min(minimum, (a + geometry::nearestShare(p, a, b) * (b - a) - p).squaredNorm());
      }
      out[t] = std::sqrt(minimum);
    }
  });
  return out;
}

} // namespace voluta::planar
