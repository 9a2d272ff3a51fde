// Placement of a part before planning: scale, rotation and position on the plate.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <string>

namespace voluta::geometry {

// Returns the mesh scaled about the origin, then moved so that its bounding box is centred over the
// origin in x and y and its lowest point is at z = 0. Precondition (Error{Internal}): scale > 0 and
// finite, mesh not empty.
TriangleMesh placeOnPlate(const TriangleMesh& mesh, double scale);

// Orientation and position of a part.
struct Placement {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); // of the part as loaded
  Eigen::Vector2d centreMm{0.0, 0.0}; // centre of its bounding box, work frame
  double liftMm = 0.0;                // height of its lowest point above the plate
};

// Returns the mesh rotated, scaled and moved so that its bounding box is centred over `centreMm`
// and its lowest point is at z = liftMm. The default placement gives placeOnPlate(mesh, scale), bit
// by bit. Precondition (Error{Internal}): scale > 0 and finite, mesh not empty, all numbers of the
// placement finite, the rotation not zero (it is normalised).
TriangleMesh place(const TriangleMesh& mesh, double scale, const Placement& placement);

// Returns the smallest rotation after which `normal` points straight down: the part then rests on
// the facet with that outward normal. Precondition (Error{Internal}): finite, not zero.
Eigen::Quaterniond rotationLayingFlat(const Eigen::Vector3d& normal);

// A doubt about the unit of a file's lengths; it is reported only, never applied.
struct UnitGuess {
  double longestSideMm = 0.0; // as read, assumed to be mm
  std::string unit = "mm";    // "mm", "m", "inch" or "um", as suggested by the size
  double scale = 1.0;         // to mm, if the guess is right
  base::Message note;         // one sentence; empty if mm is plausible
};
// Longest side of the bounding box below 2: metres if that gives 20 mm to 2 m, inches otherwise;
// above 10,000: micrometres. Sizes in between are assumed to be mm.
UnitGuess guessUnits(const TriangleMesh& mesh);

} // namespace voluta::geometry
