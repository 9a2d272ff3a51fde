// The connected parts of an area in a plane.
#pragma once

#include "geometry/polygon_paths.h"

#include <vector>

namespace voluta::toolpath {

// Returns the outline of each part with its holes.
std::vector<ClipperLib::Paths> connectedParts(const ClipperLib::Paths& area);

} // namespace voluta::toolpath
