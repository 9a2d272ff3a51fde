#include "planar/slicing/uniform_misses.h"

namespace voluta::planar {

UniformMisses uniformMisses(const voxel::SolidVoxels& part,
                            const std::function<bool(const Eigen::Vector3d&)>& isCarried) {
  const voxel::VoxelGrid& g = part.grid;
  UniformMisses out;
  out.missed.assign(part.solid.size(), 0);
  const auto printed = [&](int i, int j, int k) {
    if (!g.contains(i, j, k))
      return false;
    const std::size_t c = g.index(i, j, k);
    return part.solid[c] != 0 && out.missed[c] == 0;
  };
  const int plate = part.plateLayer();
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        const std::size_t c = g.index(i, j, k);
        if (part.solid[c] == 0 || k == plate || printed(i, j, k - 1) || printed(i - 1, j, k - 1) ||
            printed(i + 1, j, k - 1) || printed(i, j - 1, k - 1) || printed(i, j + 1, k - 1) ||
            (isCarried && isCarried(g.centre(i, j, k))))
          continue;
        out.missed[c] = 1;
        ++out.count;
      }
  return out;
}

} // namespace voluta::planar
