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

// Where faces that need support hang together: one finding for each of the five largest places, one
// for the rest (at the largest of them). Where: on the faces, near their middle. None of them
// blocks. What would help is not the same for pieces and for a part in flat layers.
enum class Overhangs { Pieces, Flat };
plan::Findings overhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                Overhangs of);

} // namespace voluta::planar
