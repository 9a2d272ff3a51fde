// Smooth normals of a mesh that keep its sharp edges.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace voluta::substrate {

using CornerNormals = std::array<Eigen::Vector3d, 3>;

// Returns per triangle the unit normals at its corners: the mean of those of the triangles around
// the vertex, weighted by area, whose normals differ from its own by less than 40 deg.
std::vector<CornerNormals> cornerNormals(const geometry::TriangleMesh& mesh);

// Returns the unit normal at a point of a triangle.
Eigen::Vector3d normalAt(const geometry::TriangleMesh& mesh, std::size_t triangle,
                         const CornerNormals& normals, const Eigen::Vector3d& point);

} // namespace voluta::substrate
