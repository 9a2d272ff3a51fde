// Parts with walls, fins and struts of one to a few beads, by the hundred, from seeds: open boxes,
// fins, trusses, blades, printer cases, lattices, vases, sheet brackets, honeycombs, impellers.
// Closed, 20 to 70 mm, standing on z = 0.
#pragma once

#include "helpers/made_parts.h"

namespace voluta::test {

struct ThinPart : MadePart {
  double thinnestMm = 0.0; // Width of its thinnest wall or strut
};

// The same solid for the same seed.
ThinPart thinPart(unsigned seed);

} // namespace voluta::test
