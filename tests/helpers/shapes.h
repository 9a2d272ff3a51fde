// Closed meshes with known measures. mm.
#pragma once

#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/triangle_mesh.h"

#include <cmath>
#include <utility>

namespace voluta::test {

inline geometry::TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  geometry::TriangleMesh m;
  for (int i = 0; i < 8; ++i)
    m.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                            i & 4 ? high.z() : low.z());
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

// For either orientation of its triangles.
inline geometry::TriangleMesh facingOutward(geometry::TriangleMesh mesh) {
  if (geometry::volume(mesh) < 0.0)
    for (auto& t : mesh.triangles)
      std::swap(t[1], t[2]);
  return mesh;
}

// Adds the triangles of `other` to `mesh`, turned inside out if `reversed`.
inline void append(geometry::TriangleMesh& mesh, const geometry::TriangleMesh& other,
                   bool reversed = false) {
  const int offset = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto t : other.triangles) {
    if (reversed)
      std::swap(t[1], t[2]);
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
}

// Sphere by latitude and longitude; vertices on the sphere.
inline geometry::TriangleMesh sphere(const Eigen::Vector3d& centre, double radius, int bands = 24) {
  geometry::TriangleMesh m;
  const int around = 2 * bands;
  m.vertices.push_back(centre + Eigen::Vector3d(0, 0, -radius));
  for (int i = 1; i < bands; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = base::kPi * i / bands, b = 2 * base::kPi * j / around;
      m.vertices.push_back(centre + radius * Eigen::Vector3d(std::sin(a) * std::cos(b),
                                                             std::sin(a) * std::sin(b),
                                                             -std::cos(a)));
    }
  m.vertices.push_back(centre + Eigen::Vector3d(0, 0, radius));
  const auto at = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  const int top = static_cast<int>(m.vertices.size()) - 1;
  for (int j = 0; j < around; ++j) {
    m.triangles.push_back({0, at(1, j + 1), at(1, j)});
    for (int i = 1; i + 1 < bands; ++i) {
      m.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
    m.triangles.push_back({top, at(bands - 1, j), at(bands - 1, j + 1)});
  }
  return m;
}

} // namespace voluta::test
