// Parts with known orientations.
#pragma once

#include "base/units.h"
#include "geometry/placement.h"
#include "voxel/voxel_object.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::test {

// Of cells a millimetre wide: those for which part(i, j, k) holds.
template <typename Part> geometry::TriangleMesh meshOf(int nx, int ny, int nz, Part&& part) {
  voxel::VoxelObject object;
  object.size = {nx, ny, nz};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        object.solid.push_back(part(i, j, k) ? 1 : 0);
  return voxel::surfaceOf(object);
}

// Its tip at the origin, its base at z = heightMm.
inline geometry::TriangleMesh coneOnTip(double radiusMm, double heightMm, int around) {
  geometry::TriangleMesh cone;
  for (int i = 0; i < around; ++i) {
    const double a = 2.0 * base::kPi * i / around;
    cone.vertices.emplace_back(radiusMm * std::cos(a), radiusMm * std::sin(a), heightMm);
  }
  cone.vertices.emplace_back(0, 0, 0);
  cone.vertices.emplace_back(0, 0, heightMm);
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    cone.triangles.push_back({i, around, next});
    cone.triangles.push_back({i, next, around + 1});
  }
  return cone;
}

// On the plate.
inline geometry::TriangleMesh turned(const geometry::TriangleMesh& mesh,
                                     const Eigen::Quaterniond& rotation) {
  geometry::Placement placement;
  placement.rotation = rotation;
  return geometry::place(mesh, 1.0, placement);
}

} // namespace voluta::test
