// Measures of meshes that only tests need.
#pragma once

#include "geometry/edges.h"
#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace voluta::test {

// Of the solid that a closed mesh encloses, at uniform density, mm.
inline Eigen::Vector3d centreOfMass(const geometry::TriangleMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const double tetrahedron = a.dot(b.cross(c)) / 6.0;
    sum += tetrahedron * (a + b + c) / 4.0;
    volume += tetrahedron;
  }
  return sum / volume;
}

// Each edge counted once.
inline std::size_t edgeCount(const geometry::TriangleMesh& mesh) {
  std::size_t count = 0;
  const std::vector<geometry::HalfEdge> edges = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(edges, [&](std::size_t, std::size_t) { ++count; });
  return count;
}

} // namespace voluta::test
