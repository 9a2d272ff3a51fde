#include "geometry/simplify.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace voluta::geometry {

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t triangles) {
  if (mesh.triangles.size() <= triangles)
    return mesh;
  std::optional<CgalMesh> collapsing = toCgal(mesh);
  if (!collapsing)
    return mesh;
  const CGAL::Surface_mesh_simplification::Count_stop_predicate<CgalMesh> stop(3 * triangles / 2);
  CGAL::Surface_mesh_simplification::edge_collapse(*collapsing, stop);
  collapsing->collect_garbage();
  return fromCgal(*collapsing);
}

} // namespace voluta::geometry
