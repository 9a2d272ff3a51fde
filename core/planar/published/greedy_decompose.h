// Decomposition by the published greedy scheme.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/planar_decomposition.h"

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
// fine cuts. Deviations from the source:
// - The part keeps its orientation; the source turns it to the root's best direction (see
//   placement::Objective::MinAfterCuts).
// - Constraint I, a substitute for the head's shape, holds in the coarse cuts. In the fine cuts, if
//   options.head is given, sections may end at one another, and a cut is refused if it increases
//   the number of pieces that the head's true shape does not reach past the others. Without a head
//   constraint I holds throughout.
// - Offsets are halved twice where those every 5 mm gain nothing, and then less contact with the
//   plate is kept (withLessContact).
// - Pieces that would have no base are not cut off.
// - A fine cut gains 0.2 % of the initial risky area at least.
// blockedPieces counts the pieces that the head does not reach: those of the coarse cuts, which
// only constraints I and II limit. Uses options.rule, head, plate, minVolumeMm3, target,
// searchTriangles and maxCuts. Precondition: `part` is closed, its faces point outward and it is
// on z = 0. The result does not depend on the number of threads. Throws Error{UnusableInput} if the
// part is not closed or the root is not on the plate; Cancelled.
PlanarDecomposition greedyDecompose(const geometry::TriangleMesh& part,
                                    const PlanarOptions& options, const GreedyOptions& greedy,
                                    const base::RunContext& ctx);

} // namespace voluta::planar
