// Patterns of sparse infill: functions of space that the layers cut, so that the lines of a layer
// rest on those of the layer below. One row of the table each.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string_view>

namespace voluta::toolpath {

// How often lines have branched, each into two, and how far the two are from where they began.
struct Branching {
  int times = 0;        // Completed: neighbouring lines are 2^times as close as the pattern's
  double apartMm = 0.0; // 0: the next branching has not begun
};

// The lines of a pattern are where the value is an integer plus one half. The point is in the
// pattern's frame [mm]: z along the build direction.
using PatternValue = std::function<double(const Eigen::Vector3d&, const Branching&)>;

struct SparsePattern {
  std::string_view id;
  base::Text label;
  // Lines per area of a layer, averaged over the layers: lengthPerArea / period - cornerLoss * bead
  // / period^2. The second term is lost where lines turn away from each other.
  double lengthPerArea = 1.0, cornerLoss = 0.0;
  double repeatsAfter = 1.0; // [periods] along y
  // Distance between neighbouring lines, and the longest span of solid infill above [periods]
  double spacing = 1.0, span = 1.0;
  // Returns the pattern's values for a period [mm]. Where lines of a layer would cross, they turn
  // away from each other at a distance of `beadMm`.
  PatternValue (*value)(double periodMm, double beadMm) = nullptr;
  bool followsWalls = false; // y is the distance from the innermost wall instead
  bool isGraded = false;     // dense in the middle, by pithGrading(), and thin beside the walls

  // hatchMm: area of a line's cross-section by its height. density: in (0, 1).
  double periodMm(double density, double hatchMm, double beadMm) const;
};

// Returns all patterns; the first is the default.
std::span<const SparsePattern> sparsePatterns();
// Throws Error{Usage} for an unknown id, naming the nearest.
const SparsePattern& sparsePattern(std::string_view id);

} // namespace voluta::toolpath
