// Better-shaped triangles for a cut surface, its boundary kept.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"

namespace voluta::layers {

struct CleanOptions {
  double shortEdgeMm = 0.15;         // edges shorter than this are taken out
  double boundaryToleranceMm = 2e-3; // by this much a boundary may move in doing so
  bool flipEdges = true;             // turn edges where that opens small angles
};

// Takes out short edges by moving one end onto the other (vertices are dropped, never moved, so
// boundary vertices stay on the part), where the surface stays a manifold with the same topology,
// no triangle turns over or gets much worse; then turns edges to open small angles where the
// surface is nearly flat. Independent sets in rounds, shortest first: the same result always.
// Precondition: triangles are consistently oriented. Throws Cancelled.
void cleanSurface(LevelSurface& surface, const CleanOptions& options, const base::RunContext& ctx);

} // namespace voluta::layers
