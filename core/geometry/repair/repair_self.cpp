#include "geometry/cgal_mesh.h"
#include "geometry/measures.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

namespace voluta::geometry {

bool removeSelfIntersections(TriangleMesh& mesh, const base::RunContext& ctx) {
  ctx.checkpoint();
  auto cgal = toCgal(mesh);
  if (!cgal)
    return false;
  try {
    if (!CGAL::Polygon_mesh_processing::experimental::autorefine_and_remove_self_intersections(
            *cgal))
      return false;
  } catch (const std::exception&) {
    return false; // CGAL found a precondition broken
  }
  mesh = fromCgal(*cgal);
  return !mesh.empty();
}

} // namespace voluta::geometry
