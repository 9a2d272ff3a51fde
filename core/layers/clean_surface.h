// Improves the triangles of a cut surface and keeps its boundary.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"

namespace voluta::layers {

struct CleanOptions {
  double shortEdgeMm = 0.15;         // edges shorter than this are removed
  double boundaryToleranceMm = 2e-3; // maximum displacement of the boundary
  bool flipEdges = true;             // flip edges where that opens small angles
};

// Removes short edges by collapsing one end onto the other (vertices are dropped, never moved, so
// that boundary vertices stay on the part), provided the surface remains a manifold of the same
// topology and no triangle turns over or becomes much worse. Then flips edges to open small angles
// where the surface is nearly flat. Works in rounds on independent sets, shortest edges first;
// deterministic. Precondition: triangles are consistently oriented. Throws Cancelled.
void cleanSurface(LevelSurface& surface, const CleanOptions& options, const base::RunContext& ctx);

} // namespace voluta::layers
