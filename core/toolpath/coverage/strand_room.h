// Distance between the parts of centrelines that run side by side.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// Returns per curve and point the distance [mm] to the nearest other curve or other part of the
// same curve, at most `reachMm`. Points that are nearer along the curve than 1.5 `reachMm` belong
// to the same part.
std::vector<std::vector<double>> strandRoom(const std::vector<SurfaceCurve>& curves,
                                            double reachMm);

} // namespace voluta::toolpath
