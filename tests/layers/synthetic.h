// Parts with a field in closed form, as if curved mode had grown them.
#pragma once

#include "base/units.h"
#include "curved/decomposition.h"
#include "helpers/shapes.h"
#include "voxel/solid_voxels.h"

#include <functional>

namespace voluta::test {

using FieldFunction = std::function<double(const Eigen::Vector3d&)>;

inline curved::Decomposition decompositionOf(const geometry::TriangleMesh& part, double pitch,
                                             const FieldFunction& field) {
  const voxel::SolidVoxels solid = voxel::solidVoxels(part, pitch, {});
  curved::Decomposition d;
  d.grid = solid.grid;
  d.growth = "synthetic";
  const std::size_t n = d.grid.cellCount();
  d.rank.assign(n, 0);
  d.field.assign(n, std::numeric_limits<float>::quiet_NaN());
  d.frontNormal.assign(n, Eigen::Vector3f::Zero());
  for (int k = 0; k < d.grid.size.z(); ++k)
    for (int j = 0; j < d.grid.size.y(); ++j)
      for (int i = 0; i < d.grid.size.x(); ++i) {
        const std::size_t c = d.grid.index(i, j, k);
        if (!solid.solid[c])
          continue;
        const double level = field(d.grid.centre(i, j, k));
        d.field[c] = static_cast<float>(level);
        d.rank[c] = std::max(1, static_cast<int>(level / pitch) + 1);
        d.frontNormal[c] = Eigen::Vector3f::UnitZ();
        ++d.voxels;
      }
  return d;
}

// A body of revolution about z from a profile of (radius, z), first and last either on the axis or
// closing the profile into a ring; counter-clockwise in the (radius, z) half-plane.
inline geometry::TriangleMesh revolved(const std::vector<Eigen::Vector2d>& profile, int around,
                                       bool ring) {
  geometry::TriangleMesh m;
  const int n = static_cast<int>(profile.size());
  for (const Eigen::Vector2d& p : profile)
    for (int j = 0; j < around; ++j) {
      const double a = 2 * base::kPi * j / around;
      m.vertices.emplace_back(p.x() * std::cos(a), p.x() * std::sin(a), p.y());
    }
  const auto at = [&](int i, int j) { return (i % n) * around + j % around; };
  // Points on the axis coincide; triangles between them are left out.
  const auto add = [&](int a, int b, int c) {
    const auto& v = m.vertices;
    const auto u = [](int i) { return static_cast<std::size_t>(i); };
    if ((v[u(b)] - v[u(a)]).cross(v[u(c)] - v[u(a)]).norm() > 1e-12)
      m.triangles.push_back({a, b, c});
  };
  for (int i = 0; i + (ring ? 0 : 1) < n; ++i)
    for (int j = 0; j < around; ++j) {
      add(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  return m;
}

} // namespace voluta::test
