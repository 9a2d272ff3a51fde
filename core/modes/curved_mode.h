// Mode "curved": curved layers.
#pragma once

#include "modes/mode.h"

namespace voluta::modes {

Mode curvedMode();

} // namespace voluta::modes
