// Pieces by the published greedy scheme.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>

namespace voluta::planar {

struct GreedyOptions {
  std::size_t clusters = 0;            // of thickness; 0: see bestMixture
  std::optional<Eigen::Vector3d> root; // a point on what is printed first; else see pieceGraph
};

// RoboFDM (Wu, Dai, Fang, Liu, Wang 2017; Dai 2020, chapter 2): a coarse decomposition by a
// skeleton's shape diameters, its order from a root, planes perturbed, pieces merged, then cut
// further greedily until options.target or nothing helps. Where no skeleton is found the fine cuts
// do alone. Constraints I and II are all that it knows of the head: blockedPieces counts what the
// head's true shape does not reach. Unlike the source the part stays as it is placed, and pieces
// that would hang in the air are not cut free. Uses options.rule, head, plate, leastVolumeMm3,
// target, searchTriangles and mostCuts. `part` is closed, faces outward and stands on z = 0. Same
// result for any number of threads. Throws Error{UnusableInput} where the part is not closed or the
// root does not stand on the plate; Cancelled.
PlanarDecomposition greedyDecompose(const geometry::TriangleMesh& part,
                                    const PlanarOptions& options, const GreedyOptions& greedy,
                                    const base::RunContext& ctx);

} // namespace voluta::planar
