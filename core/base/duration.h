// Durations as text.
#pragma once

#include "base/text.h"

namespace voluta::base {

// Returns "12 s", "5 min 30 s" or "2 h 29 min", rounded to the last unit.
Message duration(double seconds);

} // namespace voluta::base
