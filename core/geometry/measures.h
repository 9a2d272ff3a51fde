// Measures of a mesh: volume, area, bounds, normals, connected components.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::geometry {

// Returns the signed enclosed volume [mm³]: sum of tetrahedra from the bounding box's centre
// (divergence theorem). Negative for an inside-out mesh; only an estimate for an open mesh.
double volume(const TriangleMesh& mesh);

// Returns the surface area [mm²].
double area(const TriangleMesh& mesh);

// Return the area of one triangle [mm²] and its unit normal (zero for a degenerate triangle).
double triangleArea(const TriangleMesh& mesh, std::size_t triangle);
Eigen::Vector3d triangleNormal(const TriangleMesh& mesh, std::size_t triangle);

// Returns the bounding box of the vertices that triangles use [mm]; empty (isEmpty()) for an empty
// mesh.
Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

// Returns area-weighted unit normals at the vertices; zero at a vertex without triangles.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh);

// Components of triangles connected by shared edges.
struct Components {
  int count = 0;
  std::vector<int> ofTriangle; // in [0, count), numbered by their first triangle
};
Components components(const TriangleMesh& mesh);

// Returns the triangles for which keep[triangle] is set, with vertices renumbered in order of first
// use. Precondition (Error{Internal}): keep has one entry per triangle.
TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<bool>& keep);

} // namespace voluta::geometry
