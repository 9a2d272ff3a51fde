// Sizes of a mesh: volume, area, centre, edges, connected components.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::geometry {

// Signed volume enclosed, mm^3: sum of tetrahedra over the bounding box's centre (divergence
// theorem). Negative for an inside-out mesh; of an open mesh only an estimate.
double volume(const TriangleMesh& mesh);

// Surface area, mm^2.
double area(const TriangleMesh& mesh);

// Area of one triangle, mm^2, and its unit normal (zero for a degenerate triangle).
double triangleArea(const TriangleMesh& mesh, std::size_t triangle);
Eigen::Vector3d triangleNormal(const TriangleMesh& mesh, std::size_t triangle);

// Bounding box of the vertices that triangles use, mm; empty (isEmpty()) for an empty mesh.
Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

// Area-weighted unit normals at the vertices; zero at a vertex without triangles.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh);

// Triangles that hang together by shared edges.
struct Components {
  int count = 0;
  std::vector<int> ofTriangle; // in [0, count), numbered by their first triangle
};
Components components(const TriangleMesh& mesh);

// The triangles for which keep[triangle] is set, vertices renumbered in order of first use.
// Precondition (Error{Internal}): keep has one entry a triangle.
TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<bool>& keep);

} // namespace voluta::geometry
