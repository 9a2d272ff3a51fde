// The table of what a region may be for.
#pragma once

#include "base/text.h"

#include <string_view>
#include <vector>

namespace voluta::regions {

struct RegionUse {
  std::string_view id;
  base::Text label;
  bool cuts = false;      // the part ends at the region
  bool hasLayers = false; // has layers of its own, parallel to the part's upper surface
};

// In the order shown to users.
const std::vector<RegionUse>& regionUses();
// Throws Error{Usage} that names the nearest one.
const RegionUse& findUse(std::string_view id);

} // namespace voluta::regions
