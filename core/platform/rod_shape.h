// The rod on which material is wound: radius along an axis.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::platform {

// A solid around the x axis. Angles around it are measured from y to z.
struct RodShape {
  // (x, radius) [mm], x ascending; two points with equal x form a step. Linear in between.
  std::vector<Eigen::Vector2d> profile;
  int sides = 0; // 0: round; >= 3: a prism with the radius to its corners, one of them at angle 0
};

// Returns a round rod, or a prism (`diameterMm` across its corners), centred at the origin.
RodShape straightRod(double diameterMm, double lengthMm, int sides = 0);

// Throws Error{UnusableInput} naming the point: fewer than two points, descending x, more than two
// points at one x, zero length, a radius that is <= 0, NaN or infinite; 1 or 2 sides.
void checkRod(const RodShape& rod);

// Returns the surface's radius [mm] at x [mm] and an angle [rad]; the greater one at a step; 0
// beyond the ends. Precondition: checkRod.
double radiusAt(const RodShape& rod, double x, double angle);

// The minimum and maximum radius of the surface over [x0, x1]: for a prism at the middle of its
// sides and at its corners. Preconditions: checkRod; the range intersects the rod.
struct RadiusRange {
  double minMm = 0.0, maxMm = 0.0;
};
RadiusRange radiiBetween(const RodShape& rod, double x0, double x1);

// Returns a closed mesh that faces outward. The vertices of a round rod are on its surface, its
// sides deviate by at most chordMm (at least 180 sides). Preconditions: checkRod; chordMm > 0.
geometry::TriangleMesh meshOf(const RodShape& rod, double chordMm);

} // namespace voluta::platform
