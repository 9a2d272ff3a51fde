// Fill map of a part: the share of it, per cube, that beads fill, and that they are meant to fill.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}

namespace voluta::plan {
struct ToolPlan;
}

namespace voluta::pipeline {

// The share of the part filled by beads, per cube of edge `cellMm`; < 0 for a cube outside the
// part.
struct FillMap {
  double cellMm = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // In the work frame
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<double> filled; // x varies fastest
  // Per cube: the share that is meant to be filled. In sparse infill, its mean over the item
  std::vector<double> intended;
};

// Computes the map with the cells of `growing`. A cube's edge is 1/40 of the part's longest side,
// but at least one cell. `firstTriangle`: of each item in `part`; empty for a single item. Throws
// Cancelled.
FillMap fillMap(const geometry::TriangleMesh& part, std::span<const std::size_t> firstTriangle,
                const plan::ToolPlan& plan, const collision::GrowingPart& growing,
                const base::RunContext& ctx);

} // namespace voluta::pipeline
