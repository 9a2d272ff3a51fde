// Connected regions of a surface where a field exceeds a level.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct Regions {
  std::vector<int> ofVertex; // index of its region, -1 outside
  int count = 0;
};
// Returns the connected components (along edges) of the vertices with value >= level, numbered by
// their lowest vertex.
Regions regionsAbove(const PatchSurface& surface, const std::vector<double>& values, double level);

} // namespace voluta::toolpath
