// Patterns of sparse infill: functions of space that the layers cut, so that the lines of a layer
// rest on those of the layer below. One row of the table each.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string_view>

namespace voluta::toolpath {

// The lines of a pattern are where the value is an integer plus one half. The point is in the
// pattern's frame [mm]: z along the build direction.
using PatternValue = std::function<double(const Eigen::Vector3d&)>;

struct SparsePattern {
  std::string_view id;
  base::Text label;
  // Length of the lines per area in a layer, in units of 1 / period; averaged over the layers. The
  // period that yields a density is lengthPerArea * hatch / density.
  double lengthPerArea = 1.0;
  double repeatsAfter = 1.0; // [periods] along y
  // Returns the pattern's values for a period [mm]. Where lines of a layer would cross, they turn
  // away from each other at a distance of `beadMm`. Null: lines at equal distances from the edge of
  // the sparse part.
  PatternValue (*value)(double periodMm, double beadMm) = nullptr;

  // hatchMm: area of a line's cross-section by its height. density: in (0, 1).
  double periodMm(double density, double hatchMm) const {
    return lengthPerArea * hatchMm / density;
  }
};

// Returns all patterns; the first is the default.
std::span<const SparsePattern> sparsePatterns();
// Throws Error{Usage} for an unknown id, naming the nearest.
const SparsePattern& sparsePattern(std::string_view id);

} // namespace voluta::toolpath
