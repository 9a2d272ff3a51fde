// Connected parts of a surface where a field is large.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

struct Regions {
  std::vector<int> ofVertex; // number of its region, -1 outside
  int count = 0;
};
// Vertices with value >= level, joined along edges; numbered by least vertex.
Regions regionsAbove(const PatchSurface& surface, const std::vector<double>& values, double level);

} // namespace voluta::toolpath
