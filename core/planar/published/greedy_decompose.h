// Decomposition by the published greedy scheme.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>

namespace voluta::planar {

struct GreedyOptions {
  std::size_t clusters = 0;            // number of thickness classes; 0: see bestMixture
  std::optional<Eigen::Vector3d> root; // a point on the first piece; if absent see pieceGraph
};

// RoboFDM (Wu, Dai, Fang, Liu, Wang 2017; Dai 2020, chapter 2): a coarse decomposition by the shape
// diameters of a skeleton, ordered from a root, with perturbed planes and merged pieces, followed
// by greedy fine cuts until options.target or no further gain. Without a skeleton there are only
// fine cuts. The scheme considers the head only through constraints I and II: blockedPieces counts
// the pieces that the head's true shape does not reach. Unlike the source, the part keeps its
// orientation, and pieces that would have no base are not cut off. Uses options.rule, head, plate,
// leastVolumeMm3, target, searchTriangles and mostCuts. Precondition: `part` is closed, its faces
// point outward and it is on z = 0. The result does not depend on the number of threads. Throws
// Error{UnusableInput} if the part is not closed or the root is not on the plate; Cancelled.
PlanarDecomposition greedyDecompose(const geometry::TriangleMesh& part,
                                    const PlanarOptions& options, const GreedyOptions& greedy,
                                    const base::RunContext& ctx);

} // namespace voluta::planar
