// Conventional slicing of the whole part along z.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/support_rules.h"
#include "planar/planar_decomposition.h"

#include <string>

namespace voluta::planar {

// Returns the part as one piece on the plate. The area that needs support is reported as a finding
// that does not block, since small overhangs may still print well. Precondition: `part` is closed,
// its faces point outward and it is on z = 0. Throws Error{UnusableInput} if the part is not
// closed.
PlanarDecomposition flatDecomposition(const geometry::TriangleMesh& part, const RiskRule& rule);

// Returns findings for connected groups of faces that need support: one for each of the five
// largest places and one for all others (located at the largest of them). Each position is on the
// faces, near their centroid. None of the findings blocks. The remedies for pieces differ from
// those for a part in flat layers.
enum class Overhangs { Pieces, Flat };
plan::Findings overhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                Overhangs of);
// The same for the faces below which no column stands: those with SupportRule::None. If the part
// has supports, regions block them there: that is one finding.
plan::Findings openOverhangFindings(const std::vector<Piece>& pieces, const RiskRule& rule,
                                    Overhangs of, const layers::SupportRules& supports);

} // namespace voluta::planar
