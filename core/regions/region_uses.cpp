#include "regions/region_uses.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <string>

namespace voluta::regions {

const std::vector<RegionUse>& regionUses() {
  static const std::vector<RegionUse> kUses{
      {.id = "settings", .label = "Own settings"_text},
      {.id = "cut", .label = "Cut away"_text, .cuts = true},
      {.id = "surface", .label = "Layers along the surface"_text, .hasLayers = true},
  };
  return kUses;
}

const RegionUse& findUse(std::string_view id) {
  const auto found = std::ranges::find(regionUses(), id, &RegionUse::id);
  if (found != regionUses().end())
    return *found;
  std::vector<std::string> ids;
  for (const RegionUse& use : regionUses())
    ids.emplace_back(use.id);
  throw base::Error(base::ErrorCode::Usage,
                    base::message("unknown use '{name}' of a region"_text, id), {},
                    base::didYouMean(id, ids));
}

} // namespace voluta::regions
