// The rod that material is wound on: radius along an axis.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::platform {

// A solid about the x axis. Angles about it run from y to z.
struct RodShape {
  // (x, radius) in mm, x ascending; two points with the same x are a step. Straight between.
  std::vector<Eigen::Vector2d> profile;
  int sides = 0; // 0: round; 3 or more: a prism, radius to its corners, one of them at angle 0
};

// A round rod, or a prism (`diameterMm` over its corners), its middle at the origin.
RodShape straightRod(double diameterMm, double lengthMm, int sides = 0);

// Throws Error{UnusableInput}, saying which point: fewer than two points, x that runs back, more
// than two points at one x, no length, a radius <= 0 or a number that is not finite; 1 or 2 sides.
void checkRod(const RodShape& rod);

// Of the surface at x (mm) and an angle (radians), mm; the greater one at a step; 0 beyond the
// ends. Precondition: checkRod.
double radiusAt(const RodShape& rod, double x, double angle);

// Least and greatest radius of the surface over [x0, x1]: on a prism to the middle of its sides and
// to its corners. Precondition: checkRod; the range meets the rod.
struct RadiusRange {
  double leastMm = 0.0, mostMm = 0.0;
};
RadiusRange radiiBetween(const RodShape& rod, double x0, double x1);

// Closed, outward; a round rod's corners lie on it, its sides at most chordMm within (180 sides at
// least). Precondition: checkRod; chordMm > 0.
geometry::TriangleMesh meshOf(const RodShape& rod, double chordMm);

} // namespace voluta::platform
