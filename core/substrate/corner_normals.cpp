#include "substrate/corner_normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voluta::substrate {

using Eigen::Vector3d;

std::vector<CornerNormals> cornerNormals(const geometry::TriangleMesh& mesh) {
  constexpr double kSmooth = 0.7660444431189780; // cosine of 40 deg
  const std::size_t count = mesh.triangles.size();
  std::vector<Vector3d> area(count); // twice the area, along the normal
  std::vector<std::vector<std::size_t>> around(mesh.vertices.size());
  for (std::size_t t = 0; t < count; ++t) {
    area[t] = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    for (const int v : mesh.triangles[t])
      around[static_cast<std::size_t>(v)].push_back(t);
  }
  std::vector<CornerNormals> normals(count);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3d sum = Vector3d::Zero();
      for (const std::size_t other : around[static_cast<std::size_t>(mesh.triangles[t][k])])
        if (area[t].dot(area[other]) >= kSmooth * area[t].norm() * area[other].norm())
          sum += area[other];
      normals[t][k] = sum.norm() > 0.0 ? Vector3d(sum.normalized()) : Vector3d(Vector3d::UnitZ());
    }
  return normals;
}

Vector3d normalAt(const geometry::TriangleMesh& mesh, std::size_t triangle,
                  const CornerNormals& normals, const Vector3d& point) {
  const Vector3d &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1),
                 &c = mesh.corner(triangle, 2);
  const Vector3d whole = (b - a).cross(c - a);
  const double squared = whole.squaredNorm();
  if (!(squared > 0.0))
    return normals[0];
  const double ofB = (point - a).cross(c - a).dot(whole) / squared,
               ofC = (b - a).cross(point - a).dot(whole) / squared;
  return ((1.0 - ofB - ofC) * normals[0] + ofB * normals[1] + ofC * normals[2]).normalized();
}

} // namespace voluta::substrate
