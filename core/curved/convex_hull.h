// Convex hull of points with integer coordinates, exact.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::curved {

// Integers held in doubles: with |coordinate| <= 2^16 every product below stays under 2^53, so
// orientation tests are exact and still vectorise.
using LatticePoint = Eigen::Vector3d;
inline constexpr double kLatticeLimit = 65536.0;

struct HullFacet {
  std::array<int, 3> corner; // indices of points, counter-clockwise seen from outside
  Eigen::Vector3d normal;    // outward, not unit, integer
  double offset = 0.0;       // normal . x = offset on the facet, integer
};

// Facets (triangles) of the hull of `points`; flat faces come as several triangles. Empty when the
// points lie in one plane. Quickhull (Barber et al. 1996) with exact signs: a point counts as
// outside a facet only when it is strictly in front of it. The result depends on the order of the
// points only in how flat faces are cut into triangles.
// Precondition (Error{Internal}): coordinates are integers of magnitude <= kLatticeLimit.
std::vector<HullFacet> convexHull(const std::vector<LatticePoint>& points);

} // namespace voluta::curved
