// Surfaces laid flat, lengths kept (Castelli 2020, appendix A).
#pragma once

#include <Eigen/Core>
#include <functional>

namespace voluta::substrate {

// A point about the x axis, unrolled at its own radius: around = radius * angle, the angle from y
// to z in (-pi, pi]; along = x. mm.
struct Unrolled {
  double aroundMm = 0.0, alongMm = 0.0, radiusMm = 0.0;
};
Unrolled unroll(const Eigen::Vector3d& p);
// The inverse. Precondition: radiusMm > 0.
Eigen::Vector3d roll(const Unrolled& p);

// A point over a surface of height heightMm(x) in a section (x, z), so that the surface becomes the
// plane z = heightMm(0): z less the surface's height, x kept (appendix A.1: the wave cos(x/2) takes
// (x, z) to (x, z + 1 - cos(x/2))).
Eigen::Vector2d flattened(const Eigen::Vector2d& p, const std::function<double(double)>& heightMm);

// Length of the curve (t, heightMm(t)) from a to b, a <= b, its slope given: the integral of
// sqrt(1 + slope^2), to a relative 1e-10 for a smooth slope.
double arcLength(const std::function<double(double)>& slope, double a, double b);

} // namespace voluta::substrate
