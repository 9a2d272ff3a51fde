#include "geometry/meshes_meet.h"

#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

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

// Returns a point deep inside `other` that is on an edge of `mesh` or below one of its triangles.
std::optional<Vector3d> deepPoint(const TriangleMesh& mesh, const MeshQuery& other,
                                  const Eigen::AlignedBox3d& common, double depthMm) {
  const auto isDeep = [&](const Vector3d& p) {
    return common.contains(p) && other.signedDistance(p) < -depthMm;
  };
  std::vector<MeshQuery::Hit> crossings;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Eigen::AlignedBox3d box(mesh.corner(t, 0));
    box.extend(mesh.corner(t, 1)).extend(mesh.corner(t, 2));
    if (!box.intersects(common))
      continue;
    for (int c = 0; c < 3; ++c) {
      const Vector3d from = mesh.corner(t, c), to = mesh.corner(t, (c + 1) % 3);
      if (isDeep(from))
        return from;
      // Between two crossings an edge is inside or outside.
      other.hits(from, to, crossings);
      double last = 0.0;
      for (std::size_t k = 0; k <= crossings.size(); ++k) {
        const double next = k < crossings.size() ? crossings[k].t : 1.0;
        if (const Vector3d p = from + 0.5 * (last + next) * (to - from); isDeep(p))
          return p;
        last = next;
      }
    }
    // The edges of equal parts are on the surface of each other.
    const Vector3d middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    if (const Vector3d p = middle - 2.0 * depthMm * triangleNormal(mesh, t); isDeep(p))
      return p;
  }
  return std::nullopt;
}

double minDistance(const TriangleMesh& from, const MeshQuery& to) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < from.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Vector3d corner = from.corner(t, c), next = from.corner(t, (c + 1) % 3);
      minimum = std::min(minimum, to.closest(corner, minimum).distance);
      minimum = std::min(minimum, to.closest(0.5 * (corner + next), minimum).distance);
    }
  return minimum;
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

std::optional<Vector3d> sharedPoint(const TriangleMesh& a, const TriangleMesh& b, double depthMm) {
  const Eigen::AlignedBox3d common = bounds(a).intersection(bounds(b));
  if (common.isEmpty())
    return std::nullopt;
  if (auto deep = deepPoint(a, MeshQuery(b), common, depthMm))
    return deep;
  return deepPoint(b, MeshQuery(a), common, depthMm);
}

double distanceBetween(const TriangleMesh& a, const TriangleMesh& b) {
  return std::min(minDistance(a, MeshQuery(b, MeshQuery::Of::Surface)),
                  minDistance(b, MeshQuery(a, MeshQuery::Of::Surface)));
}

} // namespace voluta::geometry
