// Curved layers, as a mode of the road.
#pragma once

#include "pipeline/modes.h"

namespace voluta::pipeline {

Mode curvedMode();

} // namespace voluta::pipeline
