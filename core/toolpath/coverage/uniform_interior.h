// Straight infill of a plane patch: well inside, lines lie evenly side by side, and what each has
// to lay is its spacing by its length. Samples of the patch are asked for the rest only.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct EvenSegment {
  double areaMm2 = 0.0, volumeMm3 = 0.0; // its share; 0: samples tell it
  double clearMm = 0.0;                  // no sample that tells anything is nearer
};

// For assignToNearestCurve(): what it need not look at.
struct UniformStretches {
  std::vector<char> triangles; // of the surface: what lies in it is of even segments; empty: none
  std::vector<std::vector<EvenSegment>> segments; // per curve, empty where none is even
};

// The least depth of what is even, by UniformInterior's numbers; infinite where nothing is.
double evenFrom(const std::vector<double>& uniformSpacingMm, const std::vector<double>& depth);

class UniformInterior {
public:
  // uniformSpacingMm: InfillLines::uniformSpacingMm, or empty; depth: per vertex, hatches of
  // `hatchMm`, of a slope of 1.1 at most. No segment is longer than `longestMm`. `surface` outlives
  // it.
  UniformInterior(const PatchSurface& surface, std::vector<double> uniformSpacingMm,
                  const std::vector<double>& depth, double hatchMm, double longestMm);

  // UniformStretches::triangles.
  const std::vector<char>& triangles() const { return triangles_; }
  UniformStretches of(const std::vector<SurfaceCurve>& curves) const;

private:
  std::vector<EvenSegment> along(const SurfaceCurve& curve) const;

  const PatchSurface& s_;
  std::vector<double> uniformSpacingMm_;
  std::vector<char> triangles_;
  std::vector<double> clearMm_; // per triangle, EvenSegment::clearMm; negative: not even
};

} // namespace voluta::toolpath
