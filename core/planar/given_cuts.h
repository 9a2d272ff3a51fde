// A part taken apart by planes that the user gives.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::planar {

// What lies above the plane and hangs on the section nearest to the point becomes a piece of its
// own, printed along the plane's normal. mm in the work frame; the point lies on the plane.
struct GivenCut {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Plane plane;
};

// A JSON list of {"point": [x, y, z], "normal": [x, y, z]}, as readUserPlanes reads it, without
// quadrilaterals. `where` names the text in errors. Throws Error{UnusableInput} that names the
// entry.
std::vector<GivenCut> readGivenCuts(const std::string& json, const std::string& where);
std::string givenCutsText(const std::vector<GivenCut>& cuts);

// The pieces that stand on a section of a cut, by place, in the order of the cuts.
std::vector<std::size_t> cutPieces(const std::vector<Piece>& pieces);
// The cuts that make these pieces, one for each of cutPieces(): a point on the section of each that
// is near its middle.
std::vector<GivenCut> cutsOf(const std::vector<Piece>& pieces);

// The pieces that the cuts make of `whole`, each cut made in turn where its plane meets what is
// left nearest to its point; sections are tagged by the cut's place in the list. Pieces come in no
// particular order. Throws Error{UnusableInput} that names the cut where its plane misses the part,
// leaves a piece that stands on nothing, or one thinner than `leastMm`; Cancelled.
std::vector<Piece> cutApart(Piece whole, const std::vector<GivenCut>& cuts, const RiskRule& rule,
                            double leastMm, const base::RunContext& ctx);

// cutApart() of a part, in print order. `part` is closed, faces outward and stands on z = 0.
// Besides throws Error{UnusableInput} where the part is not closed.
PlanarDecomposition decomposeByCuts(const geometry::TriangleMesh& part,
                                    const std::vector<GivenCut>& cuts, const PlanarOptions& options,
                                    double leastMm, const base::RunContext& ctx);

} // namespace voluta::planar
