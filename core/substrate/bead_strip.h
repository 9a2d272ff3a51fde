// One bead along a curve on a surface: its layer, and its solid.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "substrate/seam.h"

namespace voluta::substrate {

struct StripSize {
  double widthMm = 1.0, heightMm = 0.5;
  double tiltRad = 0.0; // of the nozzle from the surface's normal, to the right of the curve
};

// Returns the strip around the curve in the middle of the bead's height, as a patch of layer 0. The
// nozzle's tip is one height above the curve; directions are the surface's normals, tilted.
layers::Patch stripPatch(const SeamCurve& curve, const StripSize& size);

// Returns the closed solid of that patch: width by height, on the surface.
geometry::TriangleMesh stripSolid(const SeamCurve& curve, const StripSize& size);

} // namespace voluta::substrate
