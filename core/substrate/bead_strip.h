// One bead along a curve on a surface: its layer, and its solid.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "substrate/trace_seam.h"

namespace voluta::substrate {

struct StripSize {
  double widthMm = 1.0, heightMm = 0.5;
};

// Returns the strip around the curve in the middle of the bead's height, as a patch of layer 0.
// Directions are the surface's normals.
layers::Patch stripPatch(const SeamCurve& curve, const StripSize& size);

// Returns the closed solid of that patch: width by height, on the surface.
geometry::TriangleMesh stripSolid(const SeamCurve& curve, const StripSize& size);

} // namespace voluta::substrate
