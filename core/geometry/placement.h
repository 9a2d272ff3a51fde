// Where a part lies before anything is planned: scaled, centred, on the plate.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <string>

namespace voluta::geometry {

// The mesh scaled about the origin, then moved so that its bounding box is centred over the origin
// in x and y and its lowest point is at z = 0.
// Precondition (Error{Internal}): scale > 0 and finite, mesh not empty.
TriangleMesh placeOnPlate(const TriangleMesh& mesh, double scale);

// How and where a part lies.
struct Placement {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); // of the part as it came
  Eigen::Vector2d centreMm{0.0, 0.0}; // where the middle of its bounding box comes to, work frame
  double liftMm = 0.0;                // of its lowest point above the plate
};

// The mesh turned, scaled and moved so that its bounding box is centred over `centreMm` and its
// lowest point is at z = liftMm. The default placement gives placeOnPlate(mesh, scale), bit by bit.
// Precondition (Error{Internal}): scale > 0 and finite, mesh not empty, all numbers of the
// placement finite, a rotation that is not zero (it is normalised).
TriangleMesh place(const TriangleMesh& mesh, double scale, const Placement& placement);

// The rotation after which `normal` points straight down, by the shortest way: a part turned by it
// lies on the facet of that outward normal. Precondition (Error{Internal}): finite, not zero.
Eigen::Quaterniond rotationLayingFlat(const Eigen::Vector3d& normal);

// A doubt about the unit of a file's lengths; never acted upon, only told.
struct UnitGuess {
  double longestSideMm = 0.0; // as read, taken as mm
  std::string unit = "mm";    // "mm", "m" or "inch" or "um" as the size suggests
  double scale = 1.0;         // to mm, if the guess is right
  base::Message note;         // one sentence; empty when mm is plausible
};
// Longest side of the bounding box below 2: metres if 20 mm to 2 m come of it, inches otherwise;
// above 10,000: micrometres. Sizes between are taken as mm.
UnitGuess guessUnits(const TriangleMesh& mesh);

} // namespace voluta::geometry
