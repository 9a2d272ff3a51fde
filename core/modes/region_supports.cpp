#include "modes/region_supports.h"

#include "project/choices.h"
#include "support/supports.h"

#include <algorithm>

namespace voluta::modes {

bool supportsSomewhere(const ModeChoices& in) {
  return support::supportsWanted(in.values) ||
         std::ranges::any_of(in.choices.item().regions, [](const project::Region& region) {
           const auto own = region.parameters.find("supports");
           return own != region.parameters.end() && own->second != "none";
         });
}

} // namespace voluta::modes
