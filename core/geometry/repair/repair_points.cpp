#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/repair/repair_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

// Shares of the diagonal.
constexpr std::array kTolerances = {1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 1.5e-4, 2e-4, 3e-4};

using Cell = std::array<std::int64_t, 3>;

Cell cellOf(const Vector3d& p, const Vector3d& origin, double width) {
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    cell[k] = static_cast<std::int64_t>(std::floor((p[i] - origin[i]) / width));
  }
  return cell;
}

std::vector<int> openVertices(const TriangleMesh& mesh) {
  std::vector<int> open;
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin == 1) {
      open.push_back(edges[begin].low);
      open.push_back(edges[begin].high);
    }
  });
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}

std::size_t openEdgeCount(const TriangleMesh& mesh) {
  std::size_t count = 0;
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) { count += end - begin == 1; });
  return count;
}

std::size_t mergeWithin(TriangleMesh& mesh, double tolerance) {
  const std::vector<int> open = openVertices(mesh);
  const Vector3d origin = bounds(mesh).min();
  std::vector<std::pair<Cell, int>> cells;
  for (const int v : open)
    cells.emplace_back(cellOf(mesh.vertices[static_cast<std::size_t>(v)], origin, tolerance), v);
  std::sort(cells.begin(), cells.end());
  UnionFind sets(mesh.vertices.size());
  std::size_t merged = 0;
  for (const auto& [cell, v] : cells) {
    const Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        // Three neighbours along z are contiguous in the sorted cells.
        const Cell low{cell[0] + dx, cell[1] + dy, cell[2] - 1};
        const Cell high{cell[0] + dx, cell[1] + dy, cell[2] + 1};
        for (auto it = std::lower_bound(cells.begin(), cells.end(),
                                        std::pair<Cell, int>(low, std::numeric_limits<int>::min()));
             it != cells.end() && it->first <= high; ++it)
          if (it->second < v &&
              (mesh.vertices[static_cast<std::size_t>(it->second)] - p).squaredNorm() <=
                  tolerance * tolerance)
            merged += sets.join(v, it->second);
      }
  }
  if (merged == 0)
    return 0;
  std::vector<Vector3d> sum(mesh.vertices.size(), Vector3d::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const int v : open) {
    const auto root = static_cast<std::size_t>(sets.find(v));
    sum[root] += mesh.vertices[static_cast<std::size_t>(v)];
    ++count[root];
  }
  for (std::size_t v = 0; v < count.size(); ++v)
    if (count[v] > 1)
      mesh.vertices[v] = sum[v] / count[v];
  for (auto& t : mesh.triangles)
    for (int& v : t)
      v = sets.find(v);
  return merged;
}

} // namespace

std::size_t mergeNearbyPoints(TriangleMesh& mesh) {
  if (mesh.empty())
    return 0;
  std::vector<double> lengths;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      lengths.push_back((mesh.corner(t, k) - mesh.corner(t, (k + 1) % 3)).norm());
  const auto percent = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 100);
  std::nth_element(lengths.begin(), percent, lengths.end());
  const double diagonal = bounds(mesh).diagonal().norm(), limit = *percent / 3.0;
  TriangleMesh best;
  std::size_t bestOpen = openEdgeCount(mesh), bestMerged = 0;
  for (const double share : kTolerances) {
    const double tolerance = share * diagonal;
    if (!(tolerance > 0.0) || tolerance > limit || bestOpen == 0)
      break;
    TriangleMesh trial = mesh;
    const std::size_t merged = mergeWithin(trial, tolerance);
    dropCollapsedFaces(trial);
    const std::size_t open = openEdgeCount(trial);
    if (merged > 0 && open < bestOpen) {
      best = std::move(trial);
      bestOpen = open;
      bestMerged = merged;
    }
  }
  if (bestMerged > 0) {
    mesh = std::move(best);
    dropUnusedVertices(mesh);
  }
  return bestMerged;
}

std::size_t splitTJunctions(TriangleMesh& mesh, double tolerance) {
  std::size_t splits = 0;
  // Each round splits every triangle at one edge at most.
  for (int round = 0; round < 8; ++round) {
    std::vector<HalfEdge> open;
    const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
    forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
      if (end - begin == 1)
        open.push_back(edges[begin]);
    });
    // Sorted by x, so that an edge is tested only against vertices in its range.
    std::vector<std::pair<double, int>> vertices;
    for (const int v : openVertices(mesh))
      vertices.emplace_back(mesh.vertices[static_cast<std::size_t>(v)].x(), v);
    std::sort(vertices.begin(), vertices.end());
    std::vector<bool> touched(mesh.triangles.size(), false);
    std::size_t splitsNow = 0;
    for (const HalfEdge& e : open) {
      const auto t = static_cast<std::size_t>(e.triangle);
      if (touched[t])
        continue;
      const auto side = static_cast<std::size_t>(e.side);
      const int from = mesh.triangles[t][side], to = mesh.triangles[t][(side + 1) % 3],
                apex = mesh.triangles[t][(side + 2) % 3];
      const Vector3d a = mesh.vertices[static_cast<std::size_t>(from)],
                     b = mesh.vertices[static_cast<std::size_t>(to)];
      const double length = (b - a).norm();
      if (length <= 2.0 * tolerance)
        continue;
      std::vector<std::pair<double, int>> on;
      const double low = std::min(a.x(), b.x()) - tolerance;
      const double high = std::max(a.x(), b.x()) + tolerance;
      for (auto it = std::lower_bound(vertices.begin(), vertices.end(), std::pair(low, -1));
           it != vertices.end() && it->first <= high; ++it) {
        const int v = it->second;
        if (v == from || v == to || v == apex)
          continue;
        const Vector3d p = mesh.vertices[static_cast<std::size_t>(v)] - a;
        const double along = p.dot(b - a) / length;
        if (along > tolerance && along < length - tolerance &&
            (p - along * (b - a) / length).norm() <= tolerance)
          on.emplace_back(along, v);
      }
      if (on.empty())
        continue;
      std::sort(on.begin(), on.end());
      touched[t] = true;
      splitsNow += on.size();
      int last = from;
      for (const auto& [along, v] : on) {
        mesh.triangles.push_back({last, v, apex});
        last = v;
      }
      mesh.triangles[t] = {last, to, apex};
    }
    splits += splitsNow;
    if (splitsNow == 0)
      break;
  }
  return splits;
}

} // namespace voluta::geometry
