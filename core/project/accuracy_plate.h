// The plate for measuring a machine's sizes (Castelli 5.1.1).
#pragma once

#include "geometry/triangle_mesh.h"

namespace voluta::project {

// Nominal sizes of the plate [mm].
struct AccuracyPlate {
  double lengthMm = 50.0, widthMm = 20.0, heightMm = 5.0; // along x, y, z
  double slotLengthMm = 10.0, slotWidthMm = 5.0;          // along x, y
  double holeDiameterMm = 10.0;
  double cornerMm = 5.0; // radius of the corner that is round
};
// Returns the plate of a length along x, with a slot that is 40 mm shorter, or 50 mm from 200 mm of
// length on. Precondition: lengthMm >= 50.
AccuracyPlate accuracyPlate(double lengthMm);
// Returns its mesh, centred over the origin on z = 0: the hole on the left, the slot right of it,
// the round corner at the largest x and the smallest y.
geometry::TriangleMesh accuracyPlateMesh(const AccuracyPlate& plate);

} // namespace voluta::project
