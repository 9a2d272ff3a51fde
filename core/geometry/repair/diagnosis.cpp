#include "geometry/repair/diagnosis.h"

#include "base/error.h"
#include "geometry/boundary.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/self_intersections.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

void note(Defect& defect, const Vector3d& at) {
  if (defect.count++ == 0)
    defect.at = at;
}

Vector3d centroid(const TriangleMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

void inspectFaces(const TriangleMesh& mesh, Diagnosis& d) {
  std::vector<std::pair<std::array<int, 3>, std::size_t>> faces; // sorted corners, triangle
  std::vector<bool> used(mesh.vertices.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<int, 3> corners = mesh.triangles[t];
    for (const int v : corners) {
      base::require(v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(),
                    "diagnose: vertex indices in range");
      base::require(mesh.vertices[static_cast<std::size_t>(v)].allFinite(),
                    "diagnose: coordinates are finite");
      used[static_cast<std::size_t>(v)] = true;
    }
    std::sort(corners.begin(), corners.end());
    if (triangleArea(mesh, t) == 0.0)
      note(d.degenerateFaces, centroid(mesh, t));
    else
      faces.emplace_back(corners, t);
  }
  std::ranges::sort(faces);
  std::vector<std::size_t> again;
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].first == faces[i - 1].first)
      again.push_back(faces[i].second);
  if (!again.empty())
    d.duplicateFaces = {again.size(), centroid(mesh, std::ranges::min(again))};
  d.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

// Number of forward minus number of backward half-edges.
int balanceOf(const std::vector<HalfEdge>& edges, std::size_t begin, std::size_t end) {
  int balance = 0;
  for (std::size_t i = begin; i < end; ++i)
    balance += edges[i].forward ? 1 : -1;
  return balance;
}

// Returns whether every edge is used as often forward as backward, ignoring edges from a vertex to
// itself.
bool allCancel(const std::vector<HalfEdge>& edges) {
  bool all = true;
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    all = all && (edges[begin].low == edges[begin].high || balanceOf(edges, begin, end) == 0);
  });
  return all;
}

void inspectEdges(const TriangleMesh& mesh, Diagnosis& d, std::size_t& edgeCount) {
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  d.watertight = !mesh.empty() && allCancel(edges);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    const Vector3d at = 0.5 * (mesh.vertices[static_cast<std::size_t>(edges[begin].low)] +
                               mesh.vertices[static_cast<std::size_t>(edges[begin].high)]);
    ++edgeCount;
    if (end - begin == 1)
      note(d.boundaryEdges, at);
    else if (end - begin > 2)
      note(d.nonManifoldEdges, at);
    else if (balanceOf(edges, begin, end) != 0)
      note(d.misorientedEdges, at);
  });
}

} // namespace

bool Diagnosis::clean() const {
  return watertight && boundaryEdges.count == 0 && nonManifoldEdges.count == 0 &&
         misorientedEdges.count == 0 && duplicateFaces.count == 0 && degenerateFaces.count == 0 &&
         selfIntersections.count == 0 && insideOutComponents.count == 0;
}

std::vector<base::Message> Diagnosis::sentences() const {
  std::vector<base::Message> out;
  // With placeholders for the count and for the first place.
  const auto describe = [&](const Defect& defect, base::Text what) {
    if (defect.count > 0)
      out.emplace_back(
          what, std::vector<base::Value>{defect.count,
                                         base::Point{defect.at.x(), defect.at.y(), defect.at.z()}});
  };
  if (boundaryEdges.count > 0)
    out.push_back(base::message(
        "{count} open edge in {loops} loops, the first at {first:.2f}|"
        "{count} open edges in {loops} loops, the first at {first:.2f}"_plural,
        boundaryEdges.count, boundaryLoops,
        base::Point{boundaryEdges.at.x(), boundaryEdges.at.y(), boundaryEdges.at.z()}));
  describe(nonManifoldEdges, "{count} edge with more than two triangles, at {first:.2f}|"
                             "{count} edges with more than two triangles, the first at "
                             "{first:.2f}"_plural);
  describe(misorientedEdges,
           "{count} edge with inconsistently oriented triangles, at {first:.2f}|{count} "
           "edges with inconsistently oriented triangles, the first at {first:.2f}"_plural);
  describe(duplicateFaces, "{count} duplicate triangle, at {first:.2f}|"
                           "{count} duplicate triangles, the first at {first:.2f}"_plural);
  describe(degenerateFaces, "{count} triangle without area, at {first:.2f}|"
                            "{count} triangles without area, the first at {first:.2f}"_plural);
  describe(selfIntersections,
           "{count} pair of intersecting triangles, at {first:.2f}|{count} pairs of "
           "intersecting triangles, the first at {first:.2f}"_plural);
  describe(insideOutComponents,
           "{count} inside-out component, at {first:.2f}|{count} inside-out components, "
           "the first at {first:.2f}"_plural);
  return out;
}

bool isWatertight(const TriangleMesh& mesh) {
  return !mesh.empty() && allCancel(sortedHalfEdges(mesh));
}

Diagnosis diagnose(const TriangleMesh& mesh, const base::RunContext& ctx) {
  Diagnosis d;
  d.triangles = mesh.triangles.size();
  std::size_t edgeCount = 0;
  inspectFaces(mesh, d);
  ctx.checkpoint();
  inspectEdges(mesh, d, edgeCount);
  d.boundaryLoops = boundaryLoops(mesh).size();
  ctx.checkpoint();

  const Components parts = components(mesh);
  d.components = parts.count;
  const std::vector<bool> insideOut = insideOutComponents(mesh, parts);
  std::vector<bool> listed(insideOut.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(parts.ofTriangle[t]);
    if (insideOut[c] && !listed[c]) {
      listed[c] = true;
      note(d.insideOutComponents, centroid(mesh, t));
    }
  }
  for (const auto& [a, b] : selfIntersections(mesh, ctx))
    note(d.selfIntersections, centroid(mesh, static_cast<std::size_t>(a)));

  d.volumeMm3 = volume(mesh);
  d.areaMm2 = area(mesh);
  d.boundsMm = bounds(mesh);
  if (d.watertight && d.nonManifoldEdges.count == 0) {
    const auto euler = static_cast<long long>(d.vertices) - static_cast<long long>(edgeCount) +
                       static_cast<long long>(d.triangles);
    d.genus = static_cast<int>(d.components - euler / 2);
  }
  return d;
}

} // namespace voluta::geometry
