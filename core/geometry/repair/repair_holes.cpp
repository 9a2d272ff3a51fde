#include "geometry/boundary.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

namespace voluta::geometry {

using Eigen::Vector3d;

ClosedHoles closeHoles(TriangleMesh& mesh, const base::RunContext& ctx) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  ClosedHoles closed;
  for (const std::vector<int>& loop : boundaryLoops(mesh)) {
    ctx.checkpoint();
    std::vector<Kernel::Point_3> rim;
    Vector3d middle = Vector3d::Zero();
    for (const int v : loop) {
      const Vector3d& p = mesh.vertices[static_cast<std::size_t>(v)];
      rim.emplace_back(p.x(), p.y(), p.z());
      middle += p / static_cast<double>(loop.size());
    }
    std::vector<CGAL::Triple<int, int, int>> patch;
    if (loop.size() == 3)
      patch.emplace_back(0, 1, 2);
    else
      CGAL::Polygon_mesh_processing::triangulate_hole_polyline(rim, std::back_inserter(patch));
    if (patch.size() != loop.size() - 2) {
      ++closed.failed;
      continue;
    }
    for (const auto& t : patch)
      mesh.triangles.push_back({loop[static_cast<std::size_t>(t.first)],
                                loop[static_cast<std::size_t>(t.second)],
                                loop[static_cast<std::size_t>(t.third)]});
    ++closed.count;
    if (loop.size() > closed.largestEdges) {
      closed.largestEdges = loop.size();
      closed.largestAt = middle;
    }
  }
  return closed;
}

} // namespace voluta::geometry
