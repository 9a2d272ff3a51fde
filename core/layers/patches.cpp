#include "layers/patches.h"

#include "base/index.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/triangle_queries.h"

#include <algorithm>
#include <cmath>

namespace voluta::layers {

namespace {

using base::at;

// Creates one vertex for each edge-connected fan of triangles around a vertex.
void splitTouchingFans(LevelSurface& s) {
  auto& triangles = s.surface.triangles;
  const std::vector<geometry::HalfEdge> edges = geometry::sortedHalfEdges(s.surface);
  std::vector<std::uint8_t> boundaryEnds(s.surface.vertices.size(), 0);
  geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
    if (e - b == 1)
      for (int v : {edges[b].low, edges[b].high})
        boundaryEnds[at(v)] = static_cast<std::uint8_t>(std::min(255, boundaryEnds[at(v)] + 1));
  });
  std::vector<std::vector<int>> around(s.surface.vertices.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int v : triangles[t])
      if (boundaryEnds[at(v)] > 2)
        around[at(v)].push_back(static_cast<int>(t));
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].empty())
      continue;
    std::vector<int> rest = around[v];
    const int vertex = static_cast<int>(v);
    for (bool isFirst = true; !rest.empty(); isFirst = false) {
      std::vector<int> fan{rest.back()};
      rest.pop_back();
      for (std::size_t k = 0; k < fan.size(); ++k)
        for (std::size_t r = 0; r < rest.size();) {
          int shared = 0;
          for (int a : triangles[at(fan[k])])
            for (int b : triangles[at(rest[r])])
              shared += a == b && a != vertex ? 1 : 0;
          if (shared == 0) {
            ++r;
            continue;
          }
          fan.push_back(rest[r]);
          rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(r));
        }
      if (isFirst)
        continue;
      const int copy = appendBlend(s, vertex, vertex, 0.0);
      for (int t : fan)
        std::replace(triangles[at(t)].begin(), triangles[at(t)].end(), vertex, copy);
    }
  }
}

// Returns whether every point of the patch is closer to its boundary than `distance`.
bool narrower(const geometry::TriangleMesh& mesh, double distance) {
  const std::vector<geometry::HalfEdge> edges = geometry::sortedHalfEdges(mesh);
  std::vector<std::pair<int, int>> boundary;
  double perimeter = 0.0;
  geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
    if (e - b != 1)
      return;
    boundary.emplace_back(edges[b].low, edges[b].high);
    perimeter += (mesh.vertices[at(edges[b].low)] - mesh.vertices[at(edges[b].high)]).norm();
  });
  // The area of a strip is its width times half its boundary; therefore only long pieces need the
  // search.
  if (geometry::area(mesh) > distance * perimeter)
    return false;
  const auto isNear = [&](const Eigen::Vector3d& p) {
    return std::any_of(boundary.begin(), boundary.end(), [&](const std::pair<int, int>& edge) {
      return geometry::distanceToSegment(p, mesh.vertices[at(edge.first)],
                                         mesh.vertices[at(edge.second)]) < distance;
    });
  };
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isNear))
    return false;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!isNear((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0))
      return false;
  return true;
}

} // namespace

PatchesOfLevel makePatches(const LevelSurface& level, const PatchOptions& options) {
  PatchesOfLevel result;
  LevelSurface s = level;
  std::erase_if(s.surface.triangles, [](const std::array<int, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
  splitTouchingFans(s);
  const geometry::Components components = geometry::components(s.surface);
  std::vector<std::vector<std::size_t>> trianglesOf(at(components.count));
  for (std::size_t t = 0; t < s.surface.triangles.size(); ++t)
    trianglesOf[at(components.ofTriangle[t])].push_back(t);
  const double minArea = base::kPi / 4.0 * options.beadWidthMm * options.beadWidthMm;

  std::vector<int> index(s.surface.vertices.size(), -1);
  for (const std::vector<std::size_t>& piece : trianglesOf) {
    Patch patch;
    patch.layer = s.level;
    patch.chart.periodMm = s.chart.periodMm;
    std::vector<int> used;
    double area = 0.0;
    for (std::size_t t : piece) {
      std::array<int, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = s.surface.triangles[t][k];
        if (index[at(v)] < 0) {
          index[at(v)] = static_cast<int>(used.size());
          used.push_back(v);
        }
        corners[k] = index[at(v)];
      }
      patch.surface.triangles.push_back(corners);
      area += geometry::triangleArea(s.surface, t);
    }
    for (int v : used) {
      index[at(v)] = -1;
      patch.surface.vertices.push_back(s.surface.vertices[at(v)]);
      patch.thicknessMm.push_back(s.thicknessMm[at(v)]);
      if (!s.innerRim.empty())
        patch.innerRim.push_back(s.innerRim[at(v)]);
      if (!s.chart.empty())
        patch.chart.at.push_back(s.chart.at[at(v)]);
      patch.direction.push_back(s.direction[at(v)]);
      patch.clearDirection.push_back(s.clearDirection[at(v)]);
    }
    if (area < minArea || narrower(patch.surface, 0.25 * options.beadWidthMm)) {
      if (area > 0.0)
        result.slivers.push_back(std::move(patch));
      continue;
    }
    result.patches.push_back(std::move(patch));
  }
  return result;
}

} // namespace voluta::layers
