#include "geometry/meshes_meet.h"

#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <Eigen/Geometry>
#include <utility>

namespace voluta::geometry {

namespace {
using Eigen::Vector3d;

// Returns a point of the edges of `edges` on the surface of `other`, or a vertex inside it.
std::optional<Vector3d> meetingAlongEdges(const TriangleMesh& edges, const MeshQuery& other,
                                          const Eigen::AlignedBox3d& common) {
  for (std::size_t t = 0; t < edges.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Vector3d from = edges.corner(t, c), to = edges.corner(t, (c + 1) % 3);
      Eigen::AlignedBox3d box(from);
      box.extend(to);
      if (!box.intersects(common))
        continue;
      if (const auto hit = other.firstHit(from, to))
        return from + hit->t * (to - from);
    }
  for (const Vector3d& v : edges.vertices)
    if (common.contains(v) && other.inside(v))
      return v;
  return std::nullopt;
}
} // namespace

std::optional<Vector3d> meetingPoint(const TriangleMesh& a, const TriangleMesh& b) {
  const Eigen::AlignedBox3d common = bounds(a).intersection(bounds(b));
  if (common.isEmpty())
    return std::nullopt;
  if (auto met = meetingAlongEdges(a, MeshQuery(b), common))
    return met;
  return meetingAlongEdges(b, MeshQuery(a), common);
}

} // namespace voluta::geometry
