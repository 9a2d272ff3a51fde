// Heads from a few numbers, or from a mesh.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"
#include "process/process.h"

#include <optional>

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

inline constexpr double kHeadToleranceMm = 0.05;
enum class NozzlePoints { Down, Up }; // Along the z axis of a mesh

// Returns the largest radius of a mesh at each height [mm]. The tip is its lowest point (its
// highest, if the nozzle points up), and the axis passes through the middle of the tip. The result
// contains the mesh up to `toleranceMm`, and is at most `toleranceMm` larger than needed; the
// tolerance doubles while there are more than 48 sections. Throws Error{UnusableInput} if the mesh
// is empty, flat or lower than 1 mm.
HeadShape headFromMesh(const geometry::TriangleMesh& mesh, double toleranceMm = kHeadToleranceMm,
                       NozzlePoints nozzle = NozzlePoints::Down);

// Returns the reason why a head seems to point away from the part, as one that was drawn with its
// nozzle up: it is more than twice as wide at its tip as at its other end. nullopt: it does not.
std::optional<base::Message> upsideDown(const HeadShape& head);

} // namespace voluta::process
