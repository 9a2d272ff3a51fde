// Fill map of a part: the share of it, per cube, that beads fill.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}

namespace voluta::pipeline {

// The share of the part filled by beads, per cube of edge `cellMm`; < 0 for a cube outside the
// part.
struct FillMap {
  double cellMm = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // In the work frame
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<double> filled; // x varies fastest
};

// Computes the map with the cells of `growing`. A cube's edge is 1/40 of the part's longest side,
// but at least one cell. Throws Cancelled.
FillMap fillMap(const geometry::TriangleMesh& part, const collision::GrowingPart& growing,
                const base::RunContext& ctx);

} // namespace voluta::pipeline
