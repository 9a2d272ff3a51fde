#include "placement/resting_places.h"

#include "base/error.h"
#include "base/units.h"
#include "curved/convex_hull.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::placement {

namespace {

struct Facet {
  Eigen::Vector3d normal; // times twice its area
  double size = 0.0;      // its length
};

// Returns the hull's facets, largest first. Lengths are in steps of a lattice over the mesh's
// bounding box.
std::vector<Facet> hullFacets(const geometry::TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = geometry::bounds(mesh);
  const double step = 2.0 * (curved::kLatticeLimit - 1.0);
  const double perMm = step / std::max(box.sizes().maxCoeff(), 1e-9) * 0.5;
  std::vector<curved::LatticePoint> points;
  points.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices)
    if (box.contains(v)) // others belong to no triangle
      points.emplace_back((perMm * (v - box.center())).array().round());
  std::vector<Facet> facets;
  for (const curved::HullFacet& f : curved::convexHull(points)) {
    const auto at = [&](int k) { return points[static_cast<std::size_t>(f.corner[k])]; };
    const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    facets.push_back({normal, normal.norm()});
  }
  std::ranges::stable_sort(facets, std::ranges::greater{}, &Facet::size);
  return facets;
}

} // namespace

std::vector<Eigen::Vector3d> restingPlaces(const geometry::TriangleMesh& mesh,
                                           std::size_t maxCount) {
  base::require(!mesh.empty(), "restingPlaces: facets");
  const double near = std::cos(base::degreesToRadians(3.0));
  // Margin, because faces that consist of many small facets are found late
  constexpr std::size_t kPerPlace = 8;
  const std::vector<Facet> facets = hullFacets(mesh);
  std::vector<bool> taken(facets.size(), false);
  std::vector<Facet> places;
  for (std::size_t f = 0; f < facets.size() && places.size() < kPerPlace * maxCount; ++f) {
    if (taken[f] || facets[f].size == 0.0)
      continue;
    Facet place{Eigen::Vector3d::Zero()};
    for (std::size_t other = f; other < facets.size(); ++other)
      if (!taken[other] && facets[other].normal.dot(facets[f].normal) >=
                               near * facets[other].size * facets[f].size) {
        taken[other] = true;
        place.normal += facets[other].normal;
      }
    place.size = place.normal.norm();
    places.push_back(place);
  }
  std::ranges::stable_sort(places, std::ranges::greater{}, &Facet::size);
  places.resize(std::min(maxCount, places.size()));
  std::vector<Eigen::Vector3d> normals;
  for (const Facet& place : places)
    normals.push_back(place.normal / place.size);
  return normals;
}

} // namespace voluta::placement
