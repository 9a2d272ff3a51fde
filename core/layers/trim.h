// Trimming of level surfaces at the part's surface.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"
#include "layers/part_boundary.h"

namespace voluta::layers {

struct TrimOptions {
  // maximum distance of the part's surface from the chord between two boundary vertices
  double chordMm = 0.02;
  double minGapMm = 5e-4; // gaps and walls thinner than this along an edge are ignored
};

// Returns the region of a surface inside the part. The new boundary's vertices are on the part's
// facets (up to rounding); within a triangle the boundary is refined to chordMm, including sharp
// edges of the part. Attributes are interpolated. Triangles are only cut, never merged: slivers are
// left to cleanSurface. Vertices are first moved by less than 1e-5 mm, a fixed amount per index, so
// that no triangle is in a facet's plane. Works edge by edge: the crossings of a level's edges with
// the part split them until each is crossed at most once; vertices joined by uncrossed edges share
// one inside test. Features thinner than a triangle that none of its edges intersects are missed.
// (The sources trim with mesh booleans, Dai 2020, 3.4.5; this method is local: its time grows with
// the length of the boundary.) Throws Cancelled.
LevelSurface trimToPart(const LevelSurface& level, const PartBoundary& part,
                        const TrimOptions& options, const base::RunContext& ctx);

} // namespace voluta::layers
