#include "geometry/simplify.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace voluta::geometry {

namespace {
// CGAL's own predicate has another name in each of its versions.
struct StopsAtEdges {
  std::size_t edges = 0;
  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const {
    return current < edges;
  }
};
} // namespace

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t triangles) {
  if (mesh.triangles.size() <= triangles)
    return mesh;
  std::optional<CgalMesh> collapsing = toCgal(mesh);
  if (!collapsing)
    return mesh;
  CGAL::Surface_mesh_simplification::edge_collapse(*collapsing, StopsAtEdges{3 * triangles / 2});
  collapsing->collect_garbage();
  return fromCgal(*collapsing);
}

} // namespace voluta::geometry
