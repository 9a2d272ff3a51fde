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

// Centre of mass of the enclosed solid at uniform density, mm. Where the volume vanishes (open or
// flat), the centroid of the surface; zero for an empty mesh.
Eigen::Vector3d centreOfMass(const TriangleMesh& mesh);

// Area-weighted unit normals at the vertices; zero at a vertex without triangles.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh);

// Lengths of the edges, each counted once, mm. All zero for an empty mesh.
struct EdgeStatistics {
  std::size_t count = 0;
  double shortest = 0.0, mean = 0.0, median = 0.0, longest = 0.0;
};
EdgeStatistics edgeStatistics(const TriangleMesh& mesh);

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
