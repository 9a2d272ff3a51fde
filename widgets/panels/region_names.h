// The names by which regions are shown.
#pragma once

#include "project/region.h"

#include <QString>
#include <cstddef>
#include <vector>

namespace voluta::panels {

// Returns the name of a region; one without a name is called by its shape, numbered if there are
// several.
QString nameOfRegion(const std::vector<project::Region>& regions, std::size_t region);

} // namespace voluta::panels
