#include "planar/published/skeleton.h"

#include "geometry/cgal_mesh.h"
#include "geometry/measures.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace voluta::planar {

namespace {

using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<geometry::CgalMesh>;
using Meso = Skeletonization::Meso_skeleton;
using MesoEdge = boost::graph_traits<Meso>::edge_descriptor;

} // namespace

} // namespace voluta::planar

// The flow collapses short edges in the order of a set. By default that would be the order of
// memory addresses, which differs between runs; the numbers of half-edges do not.
template <> struct std::less<voluta::planar::MesoEdge> {
  bool operator()(const voluta::planar::MesoEdge& a, const voluta::planar::MesoEdge& b) const {
    return numberOf(a) < numberOf(b);
  }

private:
  static std::size_t numberOf(const voluta::planar::MesoEdge& e) {
    return std::min(e.halfedge()->id(), e.halfedge()->opposite()->id());
  }
};

namespace voluta::planar {

namespace {

// Splits create half-edges without numbers.
void number(const Meso& mesh) {
  std::size_t next = 0;
  for (const auto h : CGAL::make_range(halfedges(mesh)))
    h->id() = next++;
}

void addSkeleton(const geometry::TriangleMesh& solid, const base::RunContext& ctx,
                 CurveSkeleton& out) {
  constexpr int kMaxSteps = 200;
  const std::optional<geometry::CgalMesh> mesh = geometry::toCgal(solid);
  if (!mesh)
    return;
  Skeletonization flow(*mesh);
  const double whole = geometry::area(solid);
  double last = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    ctx.checkpoint();
    number(flow.meso_skeleton());
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
