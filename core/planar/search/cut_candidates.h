// Candidate planes for cutting a piece: all planes of many normals at once.
#pragma once

#include "base/run_context.h"
#include "planar/face_table.h"
#include "planar/pieces.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// Returns about `count` unit vectors with z >= zMin, evenly distributed over the sphere (Fibonacci
// lattice).
std::vector<Eigen::Vector3d> evenDirections(int count, double zMin);

// Returns normals of the part's own flat faces, in both signs: the directions of faces with at
// least `minShare` of the surface; at most `count`, largest area first; followed by the axes'
// directions. z >= zMin.
std::vector<Eigen::Vector3d> flatDirections(const geometry::TriangleMesh& mesh, double minShare,
                                            std::size_t count, double zMin);

// A plane and the connected part above it, which would be printed along the plane's normal instead
// of the piece's own direction.
struct CutCandidate {
  Plane plane;
  // Risky area of that part before less after, counting whole faces, less the price of the lost
  // contact area.
  double gainMm2 = 0.0;
  double afterMm2 = 0.0; // its risky area when printed along the normal
  int top = -1;          // one of its faces, the highest or nearly the highest
  Eigen::Vector3d topMm = Eigen::Vector3d::Zero(); // centroid of that face
};

struct CandidateOptions {
  double stepMm = 2.0;            // between the offsets of a normal
  double minMm2 = 1.0;            // smaller gains are not worth a cut
  double maxContactLossMm2 = 0.0; // contact area of the piece's base that may be cut off, at most
  double footPrice = 0.0;         // risky area that a mm² of contact is worth
  std::size_t perNormal = 4;      // maximum per normal
};

// Returns, for each normal, every connected part above every offset, by a sweep from the top that
// joins adjacent faces (union-find): O(normals x faces log faces). Keeps the best offset of each
// interval of stepMm; as offsets are those of vertices, planes along flat faces are found exactly.
// Omits planes whose section would itself need support on the piece. Sorted by gain; ties in the
// normals' order. Throws Cancelled.
std::vector<CutCandidate> cutCandidates(const Piece& piece, const FaceTable& faces,
                                        const RiskRule& rule,
                                        const std::vector<Eigen::Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx);

} // namespace voluta::planar
