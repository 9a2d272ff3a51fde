// How full a part is: the share of it in cubes that beads fill.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}

namespace voluta::pipeline {

// Of cubes `cellMm` wide: what share of the part in them is filled with beads; below 0: no part.
struct FillMap {
  double cellMm = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // work frame
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<double> filled; // x runs fastest
};

// Of what of the part lies in each cube, by the cells of `growing`; cubes are a fortieth of the
// part's longest side wide, or a cell. Throws Cancelled.
FillMap fillMap(const geometry::TriangleMesh& part, const collision::GrowingPart& growing,
                const base::RunContext& ctx);

} // namespace voluta::pipeline
