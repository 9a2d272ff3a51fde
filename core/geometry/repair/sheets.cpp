#include "geometry/repair/sheets.h"

#include "geometry/measures.h"
#include "geometry/repair/orientation.h"

#include <cmath>
#include <vector>

namespace voluta::geometry {

SolidsAndSheets separateSolids(const TriangleMesh& mesh) {
  const Components parts = components(mesh);
  const std::vector<bool> closed = closedComponents(mesh, parts);
  std::vector<double> volumes(closed.size(), 0.0), areas(closed.size(), 0.0);
  const Eigen::Vector3d origin = bounds(mesh).center();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(parts.ofTriangle[t]);
    const Eigen::Vector3d a = mesh.corner(t, 0) - origin, b = mesh.corner(t, 1) - origin,
                          d = mesh.corner(t, 2) - origin;
    volumes[c] += a.dot(b.cross(d)) / 6.0;
    areas[c] += triangleArea(mesh, t);
  }
  std::vector<bool> isSolid(mesh.triangles.size()), isSheet(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto c = static_cast<std::size_t>(parts.ofTriangle[t]);
    isSolid[t] = closed[c] && std::abs(volumes[c]) > 1e-9 * areas[c] * std::sqrt(areas[c]);
    isSheet[t] = !isSolid[t];
  }
  return {subMesh(mesh, isSolid), subMesh(mesh, isSheet)};
}

} // namespace voluta::geometry
