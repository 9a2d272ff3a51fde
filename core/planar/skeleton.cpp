#include "planar/skeleton.h"

#include "geometry/cgal_mesh.h"
#include "geometry/measures.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>

namespace voluta::planar {

namespace {

using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<geometry::CgalMesh>;

void addSkeleton(const geometry::TriangleMesh& solid, const base::RunContext& ctx,
                 CurveSkeleton& out) {
  constexpr int kMostSteps = 200;
  const std::optional<geometry::CgalMesh> mesh = geometry::toCgal(solid);
  if (!mesh)
    return;
  Skeletonization flow(*mesh);
  const double whole = geometry::area(solid);
  double last = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    ctx.checkpoint();
    flow.contract();
    const double area = CGAL::Polygon_mesh_processing::area(flow.meso_skeleton());
    if (std::abs(last - area) < flow.area_variation_factor() * whole)
      break;
    last = area;
  }
  Skeletonization::Skeleton skeleton;
  flow.convert_to_skeleton(skeleton);
  const int first = static_cast<int>(out.points.size());
  for (const auto v : CGAL::make_range(vertices(skeleton))) {
    const auto& p = skeleton[v].point;
    out.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto e : CGAL::make_range(edges(skeleton)))
    out.edges.push_back({first + static_cast<int>(source(e, skeleton)),
                         first + static_cast<int>(target(e, skeleton))});
}

} // namespace

CurveSkeleton curveSkeleton(const geometry::TriangleMesh& mesh, const base::RunContext& ctx) {
  CurveSkeleton out;
  const geometry::Components parts = geometry::components(mesh);
  for (int c = 0; c < parts.count; ++c) {
    std::vector<bool> keep(mesh.triangles.size());
    std::transform(parts.ofTriangle.begin(), parts.ofTriangle.end(), keep.begin(),
                   [&](int of) { return of == c; });
    const geometry::TriangleMesh shell = geometry::subMesh(mesh, keep);
    if (geometry::volume(shell) > 0.0)
      addSkeleton(shell, ctx, out);
  }
  return out;
}

} // namespace voluta::planar
