// Curved layers, as a mode of the road.
#pragma once

#include "modes/mode.h"

namespace voluta::modes {

Mode curvedMode();

} // namespace voluta::modes
