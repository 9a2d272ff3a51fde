// Supports that only regions of a part want.
#pragma once

#include "modes/from_options.h"

namespace voluta::modes {

// Returns whether supports are wanted somewhere: for the part, or in one of its regions.
bool supportsSomewhere(const ModeChoices& in);

} // namespace voluta::modes
