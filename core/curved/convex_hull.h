// Exact convex hull of points with integer coordinates.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::curved {

// Integers stored in doubles: with |coordinate| <= 2^16 every product below is less than 2^53, so
// orientation tests are exact and still vectorize.
using LatticePoint = Eigen::Vector3d;
inline constexpr double kLatticeLimit = 65536.0;

struct HullFacet {
  std::array<int, 3> corner; // Indices of points, counter-clockwise seen from outside
  Eigen::Vector3d normal;    // Outward, not normalized, integer
  double offset = 0.0;       // normal . x = offset on the facet; integer
};

// Returns the facets (triangles) of the hull of `points`; flat faces consist of several triangles.
// Empty if the points are coplanar. Quickhull (Barber et al. 1996) with exact signs: a point is
// outside a facet only if it is strictly in front of it. The order of the points only affects how
// flat faces are divided into triangles. Precondition (Error{Internal}): coordinates are integers
// of magnitude <= kLatticeLimit.
std::vector<HullFacet> convexHull(const std::vector<LatticePoint>& points);

} // namespace voluta::curved
