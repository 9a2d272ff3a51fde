#include "geometry/repair/orientation.h"

#include "geometry/box_grid.h"
#include "geometry/edges.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace voluta::geometry {

using Eigen::Vector3d;

std::vector<bool> closedComponents(const TriangleMesh& mesh, const Components& parts) {
  std::vector<bool> closed(static_cast<std::size_t>(parts.count), true);
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    int balance = 0;
    for (std::size_t i = begin; i < end; ++i)
      balance += edges[i].forward ? 1 : -1;
    if (balance != 0)
      closed[static_cast<std::size_t>(
          parts.ofTriangle[static_cast<std::size_t>(edges[begin].triangle)])] = false;
  });
  return closed;
}

std::vector<bool> insideOutComponents(const TriangleMesh& mesh, const Components& parts) {
  const auto count = static_cast<std::size_t>(parts.count);
  const std::vector<bool> closed = closedComponents(mesh, parts);
  struct Shell {
    TriangleMesh mesh;
    Eigen::AlignedBox3d box;
    Vector3d sample;
    double sign;
    std::unique_ptr<MeshQuery> query; // created on demand
  };
  std::vector<Shell> shells(count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    shells[static_cast<std::size_t>(parts.ofTriangle[t])].mesh.triangles.push_back(
        mesh.triangles[t]);
  for (std::size_t c = 0; c < count; ++c) {
    Shell& shell = shells[c];
    if (!closed[c])
      continue;
    TriangleMesh own; // a separate mesh, so that queries on many small shells stay cheap
    std::vector<int> used;
    for (const auto& t : shell.mesh.triangles)
      used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const int v : used)
      own.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
    for (auto t : shell.mesh.triangles) {
      for (int& v : t)
        v = static_cast<int>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
      own.triangles.push_back(t);
    }
    shell.mesh = std::move(own);
    shell.box = bounds(shell.mesh);
    shell.sign = volume(shell.mesh) < 0.0 ? -1.0 : 1.0;
    std::size_t largest = 0;
    for (std::size_t t = 1; t < shell.mesh.triangles.size(); ++t)
      if (triangleArea(shell.mesh, t) > triangleArea(shell.mesh, largest))
        largest = t;
    shell.sample = (shell.mesh.corner(largest, 0) + shell.mesh.corner(largest, 1) +
                    shell.mesh.corner(largest, 2)) /
                   3.0;
  }
  std::vector<Eigen::AlignedBox3d> boxes; // of the closed shells
  std::vector<std::size_t> shellOf;       // the shell of each box
  double width = 1e-6;
  for (std::size_t c = 0; c < count; ++c) {
    if (!closed[c])
      continue;
    boxes.push_back(shells[c].box);
    shellOf.push_back(c);
    width = std::max(width, shells[c].box.sizes().maxCoeff());
  }
  // Wide cells suit a few large shells, narrow ones many small.
  const BoxGrid grid(boxes,
                     width / std::cbrt(static_cast<double>(std::max(count, std::size_t{1}))));
  std::vector<bool> insideOut(count, false);
  for (const std::size_t c : shellOf) {
    double outside = 0.0;
    grid.any({shells[c].sample, shells[c].sample}, [&](std::size_t box) {
      const std::size_t other = shellOf[box];
      if (other == c || !boxes[box].contains(shells[c].sample))
        return false;
      if (!shells[other].query)
        shells[other].query = std::make_unique<MeshQuery>(shells[other].mesh);
      outside += std::round(shells[other].query->windingNumber(shells[c].sample));
      return false;
    });
    insideOut[c] = std::min(outside, outside + shells[c].sign) < 0.0;
  }
  return insideOut;
}

std::size_t orientConsistently(TriangleMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  struct Neighbour {
    int triangle = -1;
    bool agrees = true;
  };
  std::vector<std::array<Neighbour, 3>> neighbours(n);
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2)
      return;
    const HalfEdge &a = edges[begin], &b = edges[begin + 1];
    const bool agrees = a.forward != b.forward;
    neighbours[static_cast<std::size_t>(a.triangle)][static_cast<std::size_t>(a.side)] = {
        b.triangle, agrees};
    neighbours[static_cast<std::size_t>(b.triangle)][static_cast<std::size_t>(b.side)] = {
        a.triangle, agrees};
  });
  std::vector<int> turned(n, -1); // -1 not visited yet
  std::size_t count = 0;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (turned[seed] >= 0)
      continue;
    std::vector<std::size_t> patch{seed};
    turned[seed] = 0;
    double kept = 0.0, lost = 0.0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const std::size_t t = patch[i];
      (turned[t] ? lost : kept) += triangleArea(mesh, t);
      for (const Neighbour& next : neighbours[t]) {
        if (next.triangle < 0 || turned[static_cast<std::size_t>(next.triangle)] >= 0)
          continue;
        turned[static_cast<std::size_t>(next.triangle)] = next.agrees ? turned[t] : 1 - turned[t];
        patch.push_back(static_cast<std::size_t>(next.triangle));
      }
    }
    const int flip = lost > kept ? 0 : 1;
    for (const std::size_t t : patch)
      if (turned[t] == flip) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++count;
      }
  }
  return count;
}

} // namespace voluta::geometry
