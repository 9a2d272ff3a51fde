// Beads that bridge gaps: in the open, and over the sparse infill inside the part.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "replay/beads.h"
#include "replay/printed_part.h"

#include <functional>
#include <optional>
#include <vector>

namespace voluta::replay {

// What a print may bridge.
struct Bridging {
  // Returns the longest span that the material of a piece bridges [mm].
  std::function<double(const BeadPiece&)> bridgeMm;
  // The part, if its infill is sparse: its beads also span the gaps of the infill.
  std::optional<geometry::MeshQuery> sparsePart = {};
};

// Counts pieces as supported where the gap below them is a span that can be bridged: their bead is
// held before and after it, and in between it is straight and no longer than `bridgeMm`. A span is
// straight if the chord between its holds stays within half the bead's width: a bead that is pulled
// taut leaves its path where it turns in the air.
//
// A piece is held if there is material below it. Over sparse infill, which is where the place below
// it is inside the part, a bead beside it that has material below holds it too, and an end may
// stick out by the bead's width.
//
// `support`: per piece, as found from the material below. Throws Cancelled.
void acceptBridgedSpans(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                        const Bridging& bridging, std::vector<PieceSupport>& support,
                        const base::RunContext& ctx);

} // namespace voluta::replay
