#include "modes/growth_plate.h"

#include "curved/platform_polygon.h"

#include <optional>

namespace voluta::modes {

std::vector<Eigen::Vector2d> plateOf(const project::Platform& platform,
                                     const voxel::SolidVoxels& voxels,
                                     const std::vector<Eigen::Vector2d>& own) {
  const std::optional<double> margin = platform.marginMm();
  return margin && own.empty() ? curved::platformFit(voxels, *margin) : platform.plateAround(own);
}

} // namespace voluta::modes
