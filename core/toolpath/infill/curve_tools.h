// Curves on a surface: length, corners, resampling.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns the length [mm]; the closing segment counts.
double lengthOf(const SurfaceCurve& curve);

struct ResampleOptions {
  double stepMm = 1.0;   // Maximum distance of neighbouring points along the curve
  double chordMm = 0.02; // Maximum distance of the curve from the chord between neighbouring points
  // Corners that turn by more, measured over cornerWindowMm both ways, are kept as points
  double cornerRad = 0.61;
  double cornerWindowMm = 0.4;
  // No step is divided into shorter ones for the chord tolerance: they would disappear in the
  // robot's blending
  double shortestMm = 0.33;

  // Returns the options with all lengths but the step multiplied.
  ResampleOptions scaled(double factor) const {
    return {stepMm, chordMm * factor, cornerRad, cornerWindowMm * factor, shortestMm * factor};
  }
};
struct Resampled {
  SurfaceCurve curve;
  std::vector<char> corner; // Per point
};
// Returns points at even distances within each stretch between corners. Stretches are halved where
// the chord tolerance requires shorter steps. An open curve keeps its ends. Precondition: at least
// two points.
Resampled resample(const PatchSurface& surface, const SurfaceCurve& curve,
                   const ResampleOptions& options);

// Moves the points towards the midpoint of their neighbours and back onto the surface, `passes`
// times. Corners and open ends stay fixed.
void smoothCurve(const PatchSurface& surface, SurfaceCurve& curve, const std::vector<char>& fixed,
                 int passes);

} // namespace voluta::toolpath
