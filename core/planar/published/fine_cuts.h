// Further greedy cuts of pieces, each minimizing the risky area.
#pragma once

#include "base/run_context.h"
#include "planar/planar_decomposition.h"
#include "planar/plate_contact.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::planar {

struct FineCutOptions {
  std::size_t pieces = 6; // pieces with the most risky area that are examined for each cut (k)
  int normals = 100;      // number over the allowed directions (PlanarOptions::lowestZ)
  double stepMm = 5.0;    // distance between offsets, halved up to twice where none gains
  double minMm2 = 1.0;    // smaller gains do not justify a cut
  double spacingMm = 2.0; // of the points at which the head is checked
  Footing footing;        // of the part: see constrainedCut
  double targetMm2 = 0.0; // stop at this risky area of all pieces
};

// RoboFDM, phase III, fine decomposition: repeatedly cuts by the plane that removes the most risky
// area (eq. 2 of RoboFDM), out of all planes through the first pieces of the queue that fulfil
// constraints I and II (II: options.lowestZ = kFacesUp). With options.head, constraint I is
// replaced by the condition that it represents: sections may end at one another, but no cut
// increases the number of pieces that the head does not reach past the others. For a piece without
// such a plane, offsets are halved, twice at most, and then less contact with the plate is kept
// (withLessContact). Everything above a plane is cut off except for splinters smaller than
// options.minVolumeMm3; if that would leave a solid without a base, only the one solid above it
// with the largest gain. Sections are tagged from `firstTag` on, which is incremented. Throws
// Cancelled.
std::vector<Piece> fineCuts(std::vector<Piece> pieces, const PlanarOptions& options,
                            const FineCutOptions& fine, std::int32_t& firstTag,
                            const base::RunContext& ctx);

} // namespace voluta::planar
