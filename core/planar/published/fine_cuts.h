// Pieces cut further where that leaves least risky area, one cut at a time.
#pragma once

#include "base/run_context.h"
#include "planar/decomposition.h"
#include "planar/plate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::planar {

struct FineCutOptions {
  std::size_t pieces = 6; // with most risky area that are looked at for each cut (k)
  int normals = 100;      // over the upper half sphere
  double stepMm = 5.0;    // between offsets
  double leastMm2 = 1.0;  // smaller gains are not worth a cut
  Footing footing;        // of the part: see constrainedCut
  double targetMm2 = 0.0; // risky area of all pieces at which it ends
};

// RoboFDM, phase III, fine decomposition: of all planes that keep to constraints I and II through
// one of the pieces at the top of the queue, the one that takes most risky area away (eq. 2 of
// RoboFDM), again and again. All above a plane is cut off, but for splinters of less than
// options.leastVolumeMm3; where that would leave something in the air, the one solid above it that
// is worth most. Sections are tagged from `firstTag` on, which grows past them. Throws
// Cancelled.
std::vector<Piece> fineCuts(std::vector<Piece> pieces, const PlanarOptions& options,
                            const FineCutOptions& fine, std::int32_t& firstTag,
                            const base::RunContext& ctx);

} // namespace voluta::planar
