// Where a part lies before anything is planned: scaled, centred, on the plate.
#pragma once

#include "geometry/triangle_mesh.h"

#include <string>

namespace voluta::geometry {

// The mesh scaled about the origin, then moved so that its bounding box is centred over the origin
// in x and y and its lowest point is at z = 0.
// Precondition (Error{Internal}): scale > 0 and finite, mesh not empty.
TriangleMesh placeOnPlate(const TriangleMesh& mesh, double scale);

// A doubt about the unit of a file's lengths; never acted upon, only told.
struct UnitGuess {
  double longestSideMm = 0.0; // as read, taken as mm
  std::string unit = "mm";    // "mm", "m" or "inch" or "um" as the size suggests
  double scale = 1.0;         // to mm, if the guess is right
  std::string note;           // one sentence; empty when mm is plausible
};
// Longest side of the bounding box below 2: metres if 20 mm to 2 m come of it, inches otherwise;
// above 10,000: micrometres. Sizes between are taken as mm.
UnitGuess guessUnits(const TriangleMesh& mesh);

} // namespace voluta::geometry
