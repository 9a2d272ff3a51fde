// Where to cut a piece: all planes of many normals at once.
#pragma once

#include "base/run_context.h"
#include "planar/pieces.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// About `count` unit vectors spread evenly over the sphere (Fibonacci lattice) with z >= zMin.
std::vector<Eigen::Vector3d> evenDirections(int count, double zMin);

// A plane, and what hangs together above it: a part of the piece that would be printed along the
// plane's normal instead of the piece's own direction.
struct CutCandidate {
  Plane plane;
  double gainMm2 = 0.0;  // risky area of that part before less after, faces counted whole
  double afterMm2 = 0.0; // its risky area printed along the normal
  Eigen::Vector3d top = Eigen::Vector3d::Zero(); // its highest point along the normal
};

struct CandidateOptions {
  double stepMm = 2.0;   // between the offsets of a normal
  double leastMm2 = 1.0; // smaller gains are not worth a cut
  int perNormal = 3;     // at most
};

// For each normal every part above every offset, by a sweep from the top that joins faces where
// they meet (union-find): O(normals x faces). Parts that hold some of what the piece stands on are
// left out. Best gain first; ties in the normals' order. Throws Cancelled.
std::vector<CutCandidate> cutCandidates(const Piece& piece, const RiskRule& rule,
                                        const std::vector<Eigen::Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx);

} // namespace voluta::planar
