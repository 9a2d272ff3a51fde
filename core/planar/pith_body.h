// The pith of a part as a body (TreeD printing, Castelli 6.4.4): a rod along the part's curve
// skeleton, which is printed first and carries the rest of the part.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

namespace voluta::planar {

struct PithRule {
  double share = 0.35; // radius of the pith, as a share of the part's radius at that place
  double minRadiusMm = 1.5;
  double branchGain = 0.4; // share by which the pith is thicker where it branches
};

struct PithBody {
  geometry::TriangleMesh mesh; // closed, faces outward
  int limbs = 0;               // parts of the skeleton between branchings and ends
  double lengthMm = 0.0;       // of all limbs, to the part's surface
  double minRadiusMm = 0.0, maxRadiusMm = 0.0;
};

// Returns the pith of a closed part. Each limb extends to the part's surface, where the pith is cut
// off. The part's radius at a place is the least distance from the skeleton to the surface across
// the limb; the gain fades with the distance from the branching, over the part's radius there.
// Limbs shorter than the part's radius at their branching are left out. Throws
// Error{UnusableInput} if the part is not closed or has no limbs, or if the limbs cannot be joined
// or cut; Cancelled.
PithBody pithBody(const geometry::TriangleMesh& part, const PithRule& rule,
                  const base::RunContext& ctx);

} // namespace voluta::planar
