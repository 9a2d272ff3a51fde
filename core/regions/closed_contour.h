// The closed surface around the places where a function is negative.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <functional>

namespace voluta::regions {

// A function of places [mm] and a bound below it that grows by at most 1 per mm. Both are called
// from many threads at once.
struct BoundedFunction {
  std::function<double(const Eigen::Vector3d&)> value, bound;
};

// Returns the surface on a grid of gridMm (marching cubes, curved/cell_contour.h), facing the
// positive side; empty if there is none. Precondition: the function is positive at the sides of the
// box; gridMm > 0. The result is independent of the number of threads. Throws Cancelled.
geometry::TriangleMesh closedContour(const BoundedFunction& function,
                                     const Eigen::AlignedBox3d& box, double gridMm,
                                     const base::RunContext& ctx);

} // namespace voluta::regions
