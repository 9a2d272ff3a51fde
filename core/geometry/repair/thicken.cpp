#include "base/error.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "geometry/repair/open_surface.h"
#include "geometry/repair/sheets.h"
#include "geometry/repair/winding_union.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include "geometry/cgal_mesh.h"

#include <array>
#include <utility>
#include <vector>

namespace voluta::geometry {

namespace {

// Maximum number of facets of a wrap.
constexpr double kMaxFacets = 2e6;

TriangleMesh wrapped(const TriangleMesh& sheets, double wallMm) {
  // Resolution of half the wall, so that rims are round; the estimate covers both sides of the
  // sheets in triangles of that size.
  const double alpha = 0.5 * wallMm;
  const double facets = 2.0 * area(sheets) / (0.43 * alpha * alpha);
  if (facets > kMaxFacets)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("a wall of {wall:.2f} is too thin for a surface of this size: it would need "
                      "{facets:.2g} triangles"_text,
                      base::mm(wallMm), base::number(facets)),
        {}, "thicken the surface in a modelling program"_text);
  std::vector<CgalKernel::Point_3> points;
  for (const auto& v : sheets.vertices)
    points.emplace_back(v.x(), v.y(), v.z());
  std::vector<std::array<std::size_t, 3>> faces;
  for (const auto& t : sheets.triangles)
    faces.push_back({static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                     static_cast<std::size_t>(t[2])});
  CgalMesh wrap;
  CGAL::alpha_wrap_3(points, faces, alpha, 0.5 * wallMm, wrap);
  return fromCgal(wrap);
}

} // namespace

TriangleMesh thickened(const TriangleMesh& mesh, double wallMm, const base::RunContext& ctx) {
  base::require(wallMm > 0.0, "thickened: wallMm > 0");
  auto [solids, sheets] = separateSolids(mesh);
  ctx.checkpoint();
  if (!sheets.empty())
    appendMesh(solids, wrapped(sheets, wallMm));
  ctx.checkpoint();
  return overlapsUnited(std::move(solids), ctx);
}

} // namespace voluta::geometry
