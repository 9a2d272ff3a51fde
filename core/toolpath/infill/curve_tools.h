// Curves on a surface: length, corners, even points.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// mm; the closing segment counts.
double lengthOf(const SurfaceCurve& curve);

struct ResampleOptions {
  double stepMm = 1.0;     // longest distance of neighbouring points, along the curve
  double chordMm = 0.02;   // furthest the curve may leave the chord between them
  double cornerRad = 0.61; // a turn beyond this, seen over cornerWindowMm both ways, stays a point
  double cornerWindowMm = 0.4;
};
struct Resampled {
  SurfaceCurve curve;
  std::vector<char> corner; // per point
};
// Points at even distances within each stretch between corners; stretches are halved where the
// chord asks for shorter steps. An open curve keeps its ends. Precondition: two points or more.
Resampled resample(const PatchSurface& surface, const SurfaceCurve& curve,
                   const ResampleOptions& options);

// Moves the points towards their neighbours' middle `passes` times and back onto the surface;
// corners and open ends stay.
void smoothCurve(const PatchSurface& surface, SurfaceCurve& curve, const std::vector<char>& fixed,
                 int passes);

} // namespace voluta::toolpath
