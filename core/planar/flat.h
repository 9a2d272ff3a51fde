// Ordinary slicing: the whole part along z.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

#include <string>

namespace voluta::planar {

// The part as one piece on the plate, with the area that needs support as a finding that does not
// block: what overhangs may still come out. `part` is closed, faces outward, stands on z = 0.
// Throws Error{UnusableInput} where the part is not closed.
PlanarDecomposition flatDecomposition(const geometry::TriangleMesh& part, const RiskRule& rule);

// Where faces that need support hang together: one finding ("overhang") for each of the five
// largest places, one for the rest (at the largest of them), with what would help. Where: on the
// faces, near their middle. None of them blocks.
plan::Findings overhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                const std::string& remedy);

} // namespace voluta::planar
