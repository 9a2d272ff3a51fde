// Correction of a machine's sizes in flat layers.
#pragma once

#include "planar/slicing/section.h"

#include <Eigen/Core>

namespace voluta::planar {

struct SizeCorrection {
  double scaleX = 1.0, scaleY = 1.0;
  double outlineMm = 0.0; // outlines move outwards by so much, negative: inwards
  double holeMm = 0.0;    // contours of holes move into the material by so much

  bool isNeutral() const {
    return scaleX == 1.0 && scaleY == 1.0 && outlineMm == 0.0 && holeMm == 0.0;
  }
};

// Returns the section scaled along x and y about `centre`, with its contours moved. Islands inside
// holes are outlines. Contours that meet are united; those that vanish are left out. A section
// that is not perpendicular to z, or a neutral correction, returns the section unchanged.
Section corrected(const Section& section, const SizeCorrection& correction,
                  const Eigen::Vector2d& centre);

} // namespace voluta::planar
