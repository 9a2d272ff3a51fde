// Layers wound around a turning rod, as a mode of the road.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode latheMode();

// rodAxis, rodSides, rodProfile, rodLayers, and firstLayerMm, which mode substrate has too.
base::ParameterTable latheParameters();

} // namespace voluta::modes
