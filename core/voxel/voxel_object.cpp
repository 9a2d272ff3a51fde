#include "voxel/voxel_object.h"

#include "base/error.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace voluta::voxel {

SolidVoxels solidVoxels(const VoxelObject& object, const Eigen::Matrix3i& rotation, double pitch,
                        const Eigen::Vector2d& centreMm, int liftCells) {
  base::require(pitch > 0.0, "solidVoxels: pitch > 0");
  base::require(rotation * rotation.transpose() == Eigen::Matrix3i::Identity() &&
                    rotation.determinant() == 1,
                "solidVoxels: a rotation by quarter turns");
  const auto eachSolid = [&](auto&& visit) {
    for (int k = 0; k < object.size.z(); ++k)
      for (int j = 0; j < object.size.y(); ++j)
        for (int i = 0; i < object.size.x(); ++i)
          if (object.solid[object.index(i, j, k)])
            // Twice the centre: integers before and after the rotation.
            visit(Eigen::Vector3i(rotation * Eigen::Vector3i(2 * i + 1, 2 * j + 1, 2 * k + 1)));
  };
  SolidVoxels out;
  constexpr int kNone = 1 << 30;
  Eigen::Vector3i low = Eigen::Vector3i::Constant(kNone), high = -low;
  eachSolid([&](const Eigen::Vector3i& centre) {
    low = low.cwiseMin(centre);
    high = high.cwiseMax(centre);
    ++out.count;
  });
  base::require(out.count > 0, "solidVoxels: a solid cell");
  out.grid.pitch = pitch;
  out.grid.size = (high - low) / 2 + Eigen::Vector3i(3, 3, 3);
  out.grid.origin.head<2>() = centreMm - 0.5 * pitch * out.grid.size.head<2>().cast<double>();
  out.grid.origin.z() = pitch * (liftCells - 1);
  out.solid.assign(out.grid.cellCount(), 0);
  eachSolid([&](const Eigen::Vector3i& centre) {
    const Eigen::Vector3i cell = (centre - low) / 2 + Eigen::Vector3i(1, 1, 1);
    out.solid[out.grid.index(cell.x(), cell.y(), cell.z())] = 1;
  });
  return out;
}

} // namespace voluta::voxel
