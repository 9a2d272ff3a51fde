// Level surfaces cut on the part's surface.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"
#include "layers/part_boundary.h"

namespace voluta::layers {

struct TrimOptions {
  double chordMm = 0.02;  // between two boundary vertices the part's surface bulges at most this
  double minGapMm = 5e-4; // gaps and walls thinner than this along an edge are passed over
};

// What lies inside the part of a surface that reaches beyond it. The new boundary's vertices lie on
// the part's facets (to rounding); within a triangle the boundary is refined down to chordMm, sharp
// edges of the part included. Attributes are blended. Triangles are only cut, never joined: slivers
// are left to cleanSurface. Vertices are first moved by less than 1e-5 mm, a fixed amount by
// index, so that no triangle lies in a facet's plane.
// Works edge by edge: the crossings of a level's edges with the part split them until each is
// crossed at most once; vertices joined by uncrossed edges share one answer to "inside?".
// Features thinner than a triangle that no edge of it meets are not seen. (The sources trim with
// mesh booleans, Dai 2020, 3.4.5; this is local: time grows with the length of the boundary.)
// Throws Cancelled.
LevelSurface trimToPart(const LevelSurface& level, const PartBoundary& part,
                        const TrimOptions& options, const base::RunContext& ctx);

} // namespace voluta::layers
