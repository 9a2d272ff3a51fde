// A field whose isolines are evenly spaced lines of one direction on a patch.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns per vertex a function of (nearly) unit gradient [mm], whose isolines run in that
// direction, from x towards y on a flat layer: the distance from a plane or, on surfaces inclined
// to such planes, along the surface from its section with one.
std::vector<double> acrossLines(const PatchSurface& surface, double directionRad);

} // namespace voluta::toolpath
