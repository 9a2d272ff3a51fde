// Decomposition of a part by planes that the user gives.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/planar_decomposition.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::planar {

// The solid above the plane at the section nearest to the point becomes a separate piece, printed
// along the plane's normal. Work frame [mm]; the points are on the plane.
struct GivenCut {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Plane plane;
  // Solids at these points belong to the same piece; those nearest to them above the same
  // remaining piece.
  std::vector<Eigen::Vector3d> also;
};

// Parses a JSON list of {"point": [x, y, z], "normal": [x, y, z]} like readUserPlanes, but without
// quadrilaterals and optionally with "also": [points]. `where` names the text in errors. Throws
// Error{UnusableInput} that names the entry.
std::vector<GivenCut> readGivenCuts(const std::string& json, const std::string& where);
std::string givenCutsText(const std::vector<GivenCut>& cuts);

// Returns the indices of the pieces that stand on a section of a cut, in the order of the cuts.
std::vector<std::size_t> cutPieces(const std::vector<Piece>& pieces);
// Returns the cuts that produce these pieces, one for each of cutPieces(); each point is on the
// piece's section, near its centroid.
std::vector<GivenCut> cutsOf(const std::vector<Piece>& pieces);

// Applies the cuts to `whole` in order, each where its plane intersects the remaining pieces
// nearest to its point; sections are tagged by the cut's index in the list. The order of the pieces
// is unspecified. Throws Error{UnusableInput} naming the cut if its plane misses the part, leaves a
// piece without a base, or leaves one thinner than `minMm`; Cancelled.
std::vector<Piece> cutApart(Piece whole, const std::vector<GivenCut>& cuts, const RiskRule& rule,
                            double minMm, const base::RunContext& ctx);

// Returns cutApart() of a part, in print order. Precondition: `part` is closed, its faces point
// outward and it is on z = 0. Throws as cutApart, and Error{UnusableInput} if the part is not
// closed.
PlanarDecomposition decomposeByCuts(const geometry::TriangleMesh& part,
                                    const std::vector<GivenCut>& cuts, const PlanarOptions& options,
                                    double minMm, const base::RunContext& ctx);

} // namespace voluta::planar
