// Sparse infill that is dense along the middle of a part and thin below its skin (TreeD printing,
// Castelli 6.4.4).
#pragma once

#include <span>

namespace voluta::toolpath {

// The density at a distance from the innermost wall: mean + swing cos(pi t), with t from 0 at the
// pith, the place farthest from the walls, to 1 at the walls.
struct PithGrading {
  double deepestMm = 0.0; // distance of the pith from the innermost wall
  double density = 0.0;   // averaged over the area
  double mean = 0.0, swing = 0.0;

  double densityAt(double mm) const;
  // Returns the distance at which a line of even spacing and the averaged density would be: the
  // integral of the density, over the averaged one. Rises with `mm`.
  double evenMm(double mm) const;
};

// Returns the grading that has a density on average over places with these distances from the
// innermost wall [mm], which represent these areas. Precondition: one area a place; density in
// (0, 1).
PithGrading pithGrading(std::span<const double> mm, std::span<const double> area, double density);

} // namespace voluta::toolpath
