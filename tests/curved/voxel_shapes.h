// Parts defined cell by cell. The pitch is 1 mm by default, the plate at z = 0, with one empty cell
// all round.
#pragma once

#include "voxel/solid_voxels.h"

#include <algorithm>
#include <random>
#include <vector>

namespace voluta::test {

// Cells (i, j, k) in [0, nx) x [0, ny) x [0, nz) for which part(i, j, k) holds.
template <typename Part>
voxel::SolidVoxels voxelPart(int nx, int ny, int nz, Part&& part, double pitch = 1.0) {
  voxel::SolidVoxels v;
  v.grid.pitch = pitch;
  v.grid.size = {nx + 2, ny + 2, nz + 2};
  v.grid.origin = -pitch * Eigen::Vector3d::Ones();
  v.solid.assign(v.grid.cellCount(), 0);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        if (part(i, j, k)) {
          v.solid[v.grid.index(i + 1, j + 1, k + 1)] = 1;
          ++v.count;
        }
  return v;
}

inline voxel::SolidVoxels boxPart(int nx, int ny, int nz, double pitch = 1.0) {
  return voxelPart(
      nx, ny, nz, [](int, int, int) { return true; }, pitch);
}

// Stem with a wide cap: overhang all round.
inline voxel::SolidVoxels mushroomPart() {
  return voxelPart(21, 21, 16, [](int i, int j, int k) {
    const int r2 = (i - 10) * (i - 10) + (j - 10) * (j - 10);
    return k < 10 ? r2 <= 9 : r2 <= 100;
  });
}

// Two posts and a beam: growth has to close the loop.
inline voxel::SolidVoxels archPart() {
  return voxelPart(30, 6, 18, [](int i, int, int k) { return k >= 13 || i < 6 || i >= 24; });
}

inline voxel::SolidVoxels conePart() {
  return voxelPart(25, 25, 20, [](int i, int j, int k) {
    const double r = 12.0 - 0.55 * k;
    return (i - 12) * (i - 12) + (j - 12) * (j - 12) <= r * r;
  });
}

// Some balls that grow out of one another, the first on the plate.
inline voxel::SolidVoxels blobPart(unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  struct Ball {
    Eigen::Vector3i centre;
    int radius;
  };
  std::vector<Ball> balls{{{15, 15, 3}, 5}};
  for (int b = 0; b < 6; ++b) {
    const Ball& parent = balls[static_cast<std::size_t>(draw(0, b))];
    Ball ball{parent.centre, draw(2, 4)};
    for (int a = 0; a < 3; ++a)
      ball.centre[a] =
          std::clamp(ball.centre[a] + draw(a == 2 ? -1 : -parent.radius, parent.radius), 4, 26);
    balls.push_back(ball);
  }
  return voxelPart(31, 31, 31, [&](int i, int j, int k) {
    for (const Ball& b : balls)
      if ((Eigen::Vector3i(i, j, k) - b.centre).squaredNorm() <= b.radius * b.radius)
        return true;
    return false;
  });
}

} // namespace voluta::test
