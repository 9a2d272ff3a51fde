#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::geometry {

namespace {

std::array<int, 3> sorted(std::array<int, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Returns whether the corners are an even permutation of their sorted order.
bool even(const std::array<int, 3>& c) {
  return ((c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0])) == 2;
}

// Returns the number of removed triangles.
std::size_t keepOnly(TriangleMesh& mesh, const std::vector<bool>& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (keep[t])
      mesh.triangles[kept++] = mesh.triangles[t];
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  return dropped;
}

} // namespace

std::size_t dropCollapsedFaces(TriangleMesh& mesh) {
  return std::erase_if(mesh.triangles, [](const std::array<int, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

std::size_t dropDuplicateFaces(TriangleMesh& mesh, TriangleMesh& sheets) {
  std::map<std::pair<int, int>, int> trianglesAt;
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    trianglesAt[{edges[begin].low, edges[begin].high}] = static_cast<int>(end - begin);
  });
  std::map<std::array<int, 3>, std::size_t> first[2]; // by direction
  std::vector<bool> keep(mesh.triangles.size(), true), paired(mesh.triangles.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<int, 3> corners = sorted(mesh.triangles[t]);
    const bool direction = even(mesh.triangles[t]);
    if (!first[direction].emplace(corners, t).second) {
      keep[t] = false;
      continue;
    }
    const auto opposite = first[!direction].find(corners);
    if (opposite == first[!direction].end() || !keep[opposite->second])
      continue;
    const bool held = trianglesAt[{corners[0], corners[1]}] > 3 &&
                      trianglesAt[{corners[1], corners[2]}] > 3 &&
                      trianglesAt[{corners[0], corners[2]}] > 3;
    if (held) {
      keep[t] = keep[opposite->second] = false;
      paired[t] = paired[opposite->second] = true;
    }
  }
  appendMesh(sheets, subMesh(mesh, paired));
  return keepOnly(mesh, keep);
}

std::size_t separateSheets(TriangleMesh& mesh, TriangleMesh& sheets) {
  const Components parts = components(mesh);
  const std::vector<bool> closed = closedComponents(mesh, parts);
  const double size = bounds(mesh).diagonal().norm();
  std::vector<double> volumes(static_cast<std::size_t>(parts.count), 0.0);
  std::vector<Eigen::Vector3d> origin(volumes.size(), Eigen::Vector3d::Zero());
  std::vector<bool> seen(volumes.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(parts.ofTriangle[t]);
    if (!seen[c]) {
      seen[c] = true;
      origin[c] = mesh.corner(t, 0);
    }
    const Eigen::Vector3d a = mesh.corner(t, 0) - origin[c], b = mesh.corner(t, 1) - origin[c],
                          d = mesh.corner(t, 2) - origin[c];
    volumes[c] += a.dot(b.cross(d)) / 6.0;
  }
  const auto solid = [&](std::size_t c) {
    return std::abs(volumes[c]) > (closed[c] ? 1e-12 : 1e-9) * size * size * size;
  };
  std::vector<bool> keep(mesh.triangles.size()), flat(mesh.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    keep[t] = solid(static_cast<std::size_t>(parts.ofTriangle[t]));
    flat[t] = !keep[t];
  }
  appendMesh(sheets, subMesh(mesh, flat));
  return keepOnly(mesh, keep);
}

std::size_t flipInsideOut(TriangleMesh& mesh) {
  const Components parts = components(mesh);
  const std::vector<bool> flips = insideOutComponents(mesh, parts);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (flips[static_cast<std::size_t>(parts.ofTriangle[t])])
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  return static_cast<std::size_t>(std::count(flips.begin(), flips.end(), true));
}

void dropUnusedVertices(TriangleMesh& mesh) {
  std::vector<int> renumbered(mesh.vertices.size(), -1);
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      renumbered[static_cast<std::size_t>(v)] = 0;
  int count = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (renumbered[v] == 0) {
      mesh.vertices[static_cast<std::size_t>(count)] = mesh.vertices[v];
      renumbered[v] = count++;
    }
  mesh.vertices.resize(static_cast<std::size_t>(count));
  for (auto& t : mesh.triangles)
    for (int& v : t)
      v = renumbered[static_cast<std::size_t>(v)];
}

} // namespace voluta::geometry
