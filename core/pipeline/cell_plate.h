// Selects the plate of a cell that carries a part.
#pragma once

#include "geometry/triangle_mesh.h"
#include "modes/from_options.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::pipeline {

// Returns the convex hull of a placed part's lowest vertices, up to 0.5 mm above the lowest: its
// contact area.
std::vector<Eigen::Vector2d> footOf(const geometry::TriangleMesh& part);
// Returns the corners of the cell's largest plate; empty if the cell has no plates.
std::vector<Eigen::Vector2d> largestPlate(const robot::Cell& cell);

// Additional space that the plate must provide.
struct PlateNeeds {
  bool supports = false;    // Supports below the whole part
  bool prime = false;       // A priming bead next to the whole part (toolpath/prime_path.h)
  bool primeIsRing = false; // The priming bead surrounds the part
  double primeLengthMm = 0.0;
  double primeBeadMm = 0.0; // Width of that bead; 4 for all narrower ones, which need the same room
  double brimMm = 0.0;      // A brim of this width around the foot (toolpath/brim.h)
};
PlateNeeds plateNeeds(const modes::ModeChoices& in);

// Returns the corners of the smallest of the cell's plates that carries `part` (placed, [mm]) with
// a margin around its foot and has room for `needs`. If no plate has room for the priming bead and
// the brim, returns the smallest one that carries the part; if none carries it, the largest. Throws
// Error{Usage} if the cell has no plates.
std::vector<Eigen::Vector2d> cellPlate(const robot::Cell& cell, const geometry::TriangleMesh& part,
                                       const PlateNeeds& needs);

} // namespace voluta::pipeline
