// Writes spiral vases as G-code in the manner of slicers: one continuous bead of one wall that
// rises by a layer per turn.
#pragma once

#include "sliced/slicer_writer.h"

#include <Eigen/Core>
#include <functional>

namespace voluta::test {

struct Spiral {
  // The wall's middle at a share of the turn, 0 to 1, and a height [mm].
  std::function<Eigen::Vector2d(double share, double zMm)> outline;
  int facets = 90; // Per turn
  int turns = 20;
  int bottomLayers = 0; // Of rings, from the outline to its centre (0, 0)
  int rings = 1;        // Of the bottom
  double widthMm = 1.2, heightMm = 0.6;
};

// Returns the vase in G-code. PrusaSlicer: the amount rises from 0 in the first turn, and a last
// turn at the height of its top fades out. Cura: the amount rises from a quarter. slic3r: the
// amount is the same everywhere, and no comment states layers or kinds.
Written spiralBy(Manner manner, const Spiral& spiral);

Spiral cylinderSpiral(); // A closed bottom, 28.8 mm in diameter, 24 turns
Spiral squareSpiral();   // A closed bottom, sides of 30 mm, one segment per side, 24 turns
Spiral twistedSpiral();  // Five lobes that turn by 60 degrees over 24 turns, on a level ring

} // namespace voluta::test
