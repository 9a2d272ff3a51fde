#include "geometry/measures.h"

#include "base/error.h"
#include "geometry/edges.h"

#include <algorithm>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

Vector3d areaVector(const TriangleMesh& mesh, std::size_t t) {
  return 0.5 * (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
}

} // namespace

double volume(const TriangleMesh& mesh) {
  if (mesh.empty())
    return 0.0;
  const Vector3d centre = bounds(mesh).center();
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += (mesh.corner(t, 0) - centre).dot(areaVector(mesh, t));
  return sum / 3.0;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += triangleArea(mesh, t);
  return sum;
}

double triangleArea(const TriangleMesh& mesh, std::size_t triangle) {
  return areaVector(mesh, triangle).norm();
}

Vector3d triangleNormal(const TriangleMesh& mesh, std::size_t triangle) {
  const Vector3d vector = areaVector(mesh, triangle);
  const double length = vector.norm();
  return length > 0.0 ? Vector3d(vector / length) : Vector3d(Vector3d::Zero());
}

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      box.extend(mesh.corner(t, k));
  return box;
}

std::vector<Vector3d> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Vector3d> normals(mesh.vertices.size(), Vector3d::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int v : mesh.triangles[t])
      normals[static_cast<std::size_t>(v)] += areaVector(mesh, t);
  for (Vector3d& n : normals) {
    const double length = n.norm();
    n = length > 0.0 ? Vector3d(n / length) : Vector3d(Vector3d::Zero());
  }
  return normals;
}

Components components(const TriangleMesh& mesh) {
  UnionFind sets(mesh.triangles.size());
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin + 1; i < end; ++i)
      sets.join(edges[begin].triangle, edges[i].triangle);
  });
  Components result;
  result.ofTriangle.assign(mesh.triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<int>(t)));
    if (result.ofTriangle[root] < 0)
      result.ofTriangle[root] = result.count++;
    result.ofTriangle[t] = result.ofTriangle[root];
  }
  return result;
}

TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<bool>& keep) {
  base::require(keep.size() == mesh.triangles.size(), "subMesh: one flag a triangle");
  TriangleMesh part;
  std::vector<int> renumbered(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!keep[t])
      continue;
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][k]);
      if (renumbered[v] < 0) {
        renumbered[v] = static_cast<int>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[v]);
      }
      triangle[k] = renumbered[v];
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

} // namespace voluta::geometry
