// Where to cut a piece: all planes of many normals at once.
#pragma once

#include "base/run_context.h"
#include "planar/face_table.h"
#include "planar/pieces.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// About `count` unit vectors spread evenly over the sphere (Fibonacci lattice) with z >= zMin.
std::vector<Eigen::Vector3d> evenDirections(int count, double zMin);

// Normals that planes along a part's own flat faces have, either way: of each direction that faces
// of at least `leastShare` of the surface look to; at most `count`, largest area first; with them
// those of the axes. z >= zMin.
std::vector<Eigen::Vector3d> flatDirections(const geometry::TriangleMesh& mesh, double leastShare,
                                            std::size_t count, double zMin);

// A plane, and what hangs together above it: a part of the piece that would be printed along the
// plane's normal instead of the piece's own direction.
struct CutCandidate {
  Plane plane;
  // Risky area of that part before less after, faces counted whole, less the price of what it takes
  // of what the piece stands on.
  double gainMm2 = 0.0;
  double afterMm2 = 0.0;                           // its risky area printed along the normal
  int top = -1;                                    // a face of it, its highest or nearly so
  Eigen::Vector3d topMm = Eigen::Vector3d::Zero(); // middle of that face
};

struct CandidateOptions {
  double stepMm = 2.0;   // between the offsets of a normal
  double leastMm2 = 1.0; // smaller gains are not worth a cut
  double maxContactLossMm2 =
      0.0;                   // of what the piece stands on, so much may go with what is cut off
  double footPrice = 0.0;    // risky area that a mm2 of that is worth
  std::size_t perNormal = 4; // at most
};

// For each normal every part above every offset, by a sweep from the top that joins faces where
// they meet (union-find): O(normals x faces log faces). Of each stretch of stepMm the best offset,
// which is that of a corner, so that planes along flat faces are found exactly. Planes whose
// section would itself need support on the piece are left out. Best gain first; ties in the
// normals' order. Throws Cancelled.
std::vector<CutCandidate> cutCandidates(const Piece& piece, const FaceTable& faces,
                                        const RiskRule& rule,
                                        const std::vector<Eigen::Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx);

} // namespace voluta::planar
