#include "geometry/boundary.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#include <map>
#include <numbers>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

// Keyed by the ends of a side in the order of the patch that closes the hole.
using RimNormals = std::map<std::pair<int, int>, Vector3d>;

RimNormals normalsAtRims(const TriangleMesh& mesh) {
  RimNormals normals;
  const std::vector<HalfEdge> edges = sortedHalfEdges(mesh);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    const HalfEdge& e = edges[begin];
    if (end - begin == 1)
      normals[{e.forward ? e.high : e.low, e.forward ? e.low : e.high}] =
          triangleNormal(mesh, static_cast<std::size_t>(e.triangle));
  });
  return normals;
}

std::vector<std::array<int, 3>> patchIn(const TriangleMesh& mesh, const std::vector<int>& rim) {
  if (rim.size() == 3)
    return {{rim[0], rim[1], rim[2]}};
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (const int v : rim) {
    const Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
    points.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<CGAL::Triple<int, int, int>> patch;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(patch));
  std::vector<std::array<int, 3>> triangles;
  if (patch.size() == rim.size() - 2)
    for (const auto& t : patch)
      triangles.push_back({rim[static_cast<std::size_t>(t.first)],
                           rim[static_cast<std::size_t>(t.second)],
                           rim[static_cast<std::size_t>(t.third)]});
  return triangles;
}

// Sets the area of the cap, and whether the surface ends at it.
void measure(const TriangleMesh& mesh, const RimNormals& normals, RimCap& cap) {
  constexpr double kFoldCosine = 1.0 / std::numbers::sqrt2, kFoldedShare = 0.75;
  double folded = 0.0, length = 0.0;
  for (const std::array<int, 3>& t : cap.triangles) {
    const auto at = [&](std::size_t k) {
      return mesh.vertices[static_cast<std::size_t>(t[k % 3])];
    };
    const Vector3d twice = (at(1) - at(0)).cross(at(2) - at(0));
    cap.areaMm2 += 0.5 * twice.norm();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto beside = normals.find({t[k], t[(k + 1) % 3]});
      if (beside == normals.end())
        continue;
      const double side = (at(k) - at(k + 1)).norm();
      length += side;
      if (twice.dot(beside->second) < kFoldCosine * twice.norm())
        folded += side;
    }
  }
  cap.endsSurface = folded >= kFoldedShare * length;
}

} // namespace

std::vector<RimCap> rimCaps(const TriangleMesh& mesh, const base::RunContext& ctx) {
  const RimNormals normals = normalsAtRims(mesh);
  std::vector<RimCap> caps;
  for (std::vector<int>& loop : boundaryLoops(mesh)) {
    ctx.checkpoint();
    RimCap cap;
    cap.triangles = patchIn(mesh, loop);
    cap.rim = std::move(loop);
    measure(mesh, normals, cap);
    caps.push_back(std::move(cap));
  }
  return caps;
}

} // namespace voluta::geometry
