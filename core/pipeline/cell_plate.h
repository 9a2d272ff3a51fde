// Which of the plates that a cell comes with carries a part.
#pragma once

#include "base/parameters.h"
#include "geometry/triangle_mesh.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::pipeline {

// Hull of a placed part's lowest points, as far as they count as what it stands on.
std::vector<Eigen::Vector2d> footOf(const geometry::TriangleMesh& part);
// Corners of the largest of the cell's plates; none where it comes without.
std::vector<Eigen::Vector2d> largestPlate(const robot::Cell& cell);

// What stands on the plate beside the part's foot.
struct PlateNeeds {
  bool supports = false;    // under all of the part
  bool prime = false;       // a bead beside all of the part (toolpath/prime_path.h)
  bool primeIsRing = false; // around it
  double primeLengthMm = 0.0;
};
PlateNeeds plateNeeds(const base::ParameterValues& values);

// Returns the corners of the smallest of the cell's plates that carries `part` (placed, mm), with a
// margin around its foot, and has room for what `needs` says. If none has room for the prime, the
// smallest that carries the part; if none carries it, the largest. Throws Error{Usage} if the cell
// has no plates.
std::vector<Eigen::Vector2d> cellPlate(const robot::Cell& cell, const geometry::TriangleMesh& part,
                                       const PlateNeeds& needs);

} // namespace voluta::pipeline
