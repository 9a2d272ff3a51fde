#include "planar/published/region_planes.h"

#include "geometry/symmetric_axes.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <algorithm>
#include <map>
#include <utility>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

// relative to the diagonal: displacement of points along the normals
constexpr double kOffShare = 0.01;
// relative to the diagonal: `behind` and `beyond` are this close
constexpr double kNearShare = 0.05;
constexpr std::size_t kMinEdges = 3;

struct RimEdge {
  int low = 0, high = 0;
  Vector3d middle, normal;
  double lengthMm = 0.0;
  Vector3d behind, beyond; // centroids of its two triangles
};

using Rims = std::map<std::pair<int, int>, std::vector<RimEdge>>;

Vector3d middleOf(const geometry::TriangleMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
}

Rims rimsOf(const geometry::TriangleMesh& mesh, const SurfaceRegions& regions) {
  Rims out;
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i + 1 < end; ++i) {
      auto t = static_cast<std::size_t>(sides[i].triangle),
           u = static_cast<std::size_t>(sides[i + 1].triangle);
      if (regions.ofTriangle[t] == regions.ofTriangle[u])
        continue;
      if (regions.ofTriangle[t] > regions.ofTriangle[u])
        std::swap(t, u);
      const Vector3d &p = mesh.vertices[static_cast<std::size_t>(sides[i].low)],
                     &q = mesh.vertices[static_cast<std::size_t>(sides[i].high)];
      RimEdge edge;
      edge.low = sides[i].low;
      edge.high = sides[i].high;
      edge.middle = 0.5 * (p + q);
      edge.lengthMm = (q - p).norm();
      edge.normal = (geometry::triangleNormal(mesh, t) + geometry::triangleNormal(mesh, u))
                        .stableNormalized();
      edge.behind = middleOf(mesh, t);
      edge.beyond = middleOf(mesh, u);
      out[{regions.ofTriangle[t], regions.ofTriangle[u]}].push_back(edge);
    }
  });
  return out;
}

// Returns the connected stretches of edges.
std::vector<std::vector<RimEdge>> stretches(const std::vector<RimEdge>& edges,
                                            std::size_t vertices) {
  geometry::UnionFind sets(vertices);
  for (const RimEdge& e : edges)
    sets.join(e.low, e.high);
  std::map<int, std::vector<RimEdge>> bySet;
  for (const RimEdge& e : edges)
    bySet[sets.find(e.low)].push_back(e);
  std::vector<std::vector<RimEdge>> out;
  for (auto& [root, stretch] : bySet)
    if (stretch.size() >= kMinEdges)
      out.push_back(std::move(stretch));
  return out;
}

// Returns the centroid, farthest on one side of the plane, among the region's triangles near the
// stretch.
Vector3d furthest(const geometry::TriangleMesh& mesh, const SurfaceRegions& regions, int region,
                  const RegionPlane& at, double side, double nearMm, Vector3d otherwise) {
  double best = side * at.plane.heightOf(otherwise);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (regions.ofTriangle[t] != region)
      continue;
    const Vector3d middle = middleOf(mesh, t);
    const double height = side * at.plane.heightOf(middle);
    if (height > best && std::any_of(at.rim.begin(), at.rim.end(), [&](const Vector3d& p) {
          return (p - middle).squaredNorm() < nearMm * nearMm;
        })) {
      best = height;
      otherwise = middle;
    }
  }
  return otherwise;
}

} // namespace

std::vector<RegionPlane> regionPlanes(const geometry::TriangleMesh& mesh,
                                      const SurfaceRegions& regions) {
  std::vector<RegionPlane> out;
  if (mesh.empty())
    return out;
  const double diagonal = geometry::bounds(mesh).diagonal().norm();
  for (const auto& [pair, edges] : rimsOf(mesh, regions))
    for (const std::vector<RimEdge>& stretch : stretches(edges, mesh.vertices.size())) {
      RegionPlane made;
      made.from = pair.first;
      made.to = pair.second;
      Vector3d middle = Vector3d::Zero(), behind = middle, beyond = middle;
      double length = 0.0;
      for (const RimEdge& e : stretch) {
        made.rim.push_back(e.middle);
        middle += e.lengthMm * e.middle;
        behind += e.lengthMm * e.behind;
        beyond += e.lengthMm * e.beyond;
        length += e.lengthMm;
      }
      middle /= length;
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (const RimEdge& e : stretch)
        for (const double off : {-kOffShare * diagonal, 0.0, kOffShare * diagonal}) {
          const Vector3d d = e.middle + off * e.normal - middle;
          spread += e.lengthMm * d * d.transpose();
        }
      made.plane.normal = geometry::symmetricAxes(spread).axes.col(0).normalized();
      if (made.plane.normal.dot(beyond - behind) < 0.0)
        made.plane.normal = -made.plane.normal;
      made.plane.offsetMm = made.plane.normal.dot(middle);
      const double nearMm = kNearShare * diagonal;
      made.behind = furthest(mesh, regions, made.from, made, -1.0, nearMm, stretch[0].behind);
      made.beyond = furthest(mesh, regions, made.to, made, 1.0, nearMm, stretch[0].beyond);
      out.push_back(std::move(made));
    }
  return out;
}

RegionPlane reversed(RegionPlane plane) {
  std::swap(plane.from, plane.to);
  std::swap(plane.behind, plane.beyond);
  plane.plane = {-plane.plane.normal, -plane.plane.offsetMm};
  return plane;
}

} // namespace voluta::planar
