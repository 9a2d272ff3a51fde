// Which of the plates that a cell comes with carries a part.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::pipeline {

// Corners of the smallest of the cell's plates on which, with some room about it, all stands that
// `part` (placed, mm) has on the plate; with supports all that is over it. The largest where none
// is large enough. Throws Error{Usage} where the cell has none, or one that is no plate.
std::vector<Eigen::Vector2d> cellPlate(const robot::Cell& cell, const geometry::TriangleMesh& part,
                                       bool supports);

} // namespace voluta::pipeline
