// The curve skeleton of a solid.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::planar {

struct CurveSkeleton {
  std::vector<Eigen::Vector3d> points; // mm
  std::vector<std::array<int, 2>> edges;
};

// Computes the mean-curvature flow skeleton (Tagliasacchi, Alhashim, Olson, Zhang, Mean Curvature
// Skeletons, 2012; RoboFDM, phase I, step 1) of each solid of a closed mesh that faces outward.
// Walls of cavities and non-manifold meshes have none. Throws Cancelled.
CurveSkeleton curveSkeleton(const geometry::TriangleMesh& mesh, const base::RunContext& ctx);

} // namespace voluta::planar
