// Beads that span the gaps of sparse infill inside the part.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "replay/beads.h"
#include "replay/printed_part.h"

#include <functional>
#include <utility>
#include <vector>

namespace voluta::replay {

// The interior of a part with sparse infill.
struct Interior {
  geometry::MeshQuery part;
  // Returns the longest span that the material of a piece can bridge [mm].
  std::function<double(const BeadPiece&)> bridgeMm;

  Interior(const geometry::TriangleMesh& mesh, std::function<double(const BeadPiece&)> bridge)
      : part(mesh), bridgeMm(std::move(bridge)) {}
};

// Counts pieces over the interior as supported where the gap below them is a span that can be
// bridged: their bead is held before and after it, and in between it is no longer than `bridgeMm`;
// or held on one side, with an end that is no longer than the bead is wide.
// A piece is held if there is material below it, or beside it a bead that has material below. A
// piece is over the interior if the place below it is inside the part. `support`: per piece, as
// found from the material below. Throws Cancelled.
void acceptInteriorSpans(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                         const Interior& interior, std::vector<PieceSupport>& support,
                         const base::RunContext& ctx);

} // namespace voluta::replay
