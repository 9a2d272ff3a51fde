#include "curved/platform_polygon.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/convex_polygon.h"

#include <algorithm>
#include <cmath>

namespace voluta::curved {

std::vector<Eigen::Vector2d> platformFit(const voxel::SolidVoxels& voxels, double marginMm) {
  const voxel::VoxelGrid& grid = voxels.grid;
  const int k = voxels.plateLayer();
  std::vector<Eigen::Vector2d> corners;
  if (k >= 0 && k < grid.size.z())
    for (int j = 0; j < grid.size.y(); ++j) {
      int low = grid.size.x(), high = -1;
      for (int i = 0; i < grid.size.x(); ++i)
        if (voxels.solid[grid.index(i, j, k)]) {
          low = std::min(low, i);
          high = i;
        }
      for (int side = 0; side < 2 && high >= low; ++side) {
        corners.emplace_back(grid.origin.x() + grid.pitch * low,
                             grid.origin.y() + grid.pitch * (j + side));
        corners.emplace_back(grid.origin.x() + grid.pitch * (high + 1),
                             grid.origin.y() + grid.pitch * (j + side));
      }
    }
  if (corners.empty())
    throw base::Error(base::ErrorCode::UnusableInput, "the part does not touch the plate"_text, {},
                      "drop it to the plate"_text);
  return geometry::convexPolygon(std::move(corners), marginMm);
}

std::vector<Eigen::Vector2d> platformDisc(double diameterMm, const Eigen::Vector2d& centre) {
  base::require(diameterMm > 0.0, "platformDisc: diameter > 0");
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < 64; ++i) {
    const double a = 2.0 * base::kPi * i / 64.0;
    polygon.emplace_back(centre + 0.5 * diameterMm * Eigen::Vector2d(std::cos(a), std::sin(a)));
  }
  return polygon;
}

std::vector<Eigen::Vector2d> platformRect(double widthMm, double depthMm,
                                          const Eigen::Vector2d& centre) {
  base::require(widthMm > 0.0 && depthMm > 0.0, "platformRect: width and depth > 0");
  const double x = 0.5 * widthMm, y = 0.5 * depthMm;
  return {centre + Eigen::Vector2d(-x, -y), centre + Eigen::Vector2d(x, -y),
          centre + Eigen::Vector2d(x, y), centre + Eigen::Vector2d(-x, y)};
}

} // namespace voluta::curved
