// Straight infill of a plane patch: well inside, lines are evenly spaced, and the share of each is
// its spacing times its length. Only the rest of the patch needs samples.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct EvenSegment {
  double areaMm2 = 0.0, volumeMm3 = 0.0; // The segment's share; 0: computed from samples
  double clearMm = 0.0;                  // Radius without samples that must be evaluated
};

// The parts of a surface that assignToNearestCurve() need not sample.
struct UniformStretches {
  // Per triangle of the surface: contains only area of even segments; empty: none
  std::vector<char> triangles;
  // Per curve; empty if none of its segments is even
  std::vector<std::vector<EvenSegment>> segments;
};

// Returns the minimum depth of even lines; infinite if there are none. Parameters as for
// UniformInterior.
double evenFrom(const std::vector<double>& uniformSpacingMm, const std::vector<double>& depth);

class UniformInterior {
public:
  // uniformSpacingMm: InfillLines::uniformSpacingMm, or empty. depth: per vertex, in hatches of
  // `hatchMm`, with a slope of at most 1.1. No segment is longer than `longestMm`. `surface` must
  // outlive this object.
  UniformInterior(const PatchSurface& surface, std::vector<double> uniformSpacingMm,
                  const std::vector<double>& depth, double hatchMm, double longestMm);

  // See UniformStretches::triangles.
  const std::vector<char>& triangles() const { return triangles_; }
  UniformStretches of(const std::vector<SurfaceCurve>& curves) const;

private:
  std::vector<EvenSegment> along(const SurfaceCurve& curve) const;

  const PatchSurface& s_;
  std::vector<double> uniformSpacingMm_;
  std::vector<char> triangles_;
  std::vector<double> clearMm_; // Per triangle, EvenSegment::clearMm; negative: not even
};

} // namespace voluta::toolpath
