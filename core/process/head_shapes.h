// Heads from a few numbers, or from a mesh.
#pragma once

#include "geometry/triangle_mesh.h"
#include "process/process.h"

namespace voluta::process {

// A conical nozzle below a square block, as most printers have.
struct HeadNumbers {
  double tipRadiusMm = 0.5;   // Of the nozzle's flat end
  double coneAngleDeg = 60.0; // Full angle of the cone, > 0 and < 180;
  double coneHeightMm = 6.0;  // > 0
  double blockWidthMm = 20.0; // Edge of the square; its corners are within the head
  double blockHeightMm = 40.0;
};
// Returns the head's sections. Throws Error{UnusableInput} naming the number that is not positive,
// an angle of 180 degrees or more, or a block narrower than the cone's top.
HeadShape headFromNumbers(const HeadNumbers& numbers);

// Returns the largest radius of a mesh at each height [mm]. Its z axis points into the head; the
// tip is its lowest point, and the axis passes through the middle of the tip. The result contains
// the mesh up to `toleranceMm`, and is at most `toleranceMm` larger than needed; the tolerance
// doubles while there are more than 48 sections. Throws Error{UnusableInput} if the mesh is empty,
// flat or lower than 1 mm.
HeadShape headFromMesh(const geometry::TriangleMesh& mesh, double toleranceMm = 0.05);

} // namespace voluta::process
