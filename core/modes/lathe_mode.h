// Mode "lathe": layers wound around a turning rod.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode latheMode();

// Parameters rodAxis, rodSides, rodProfile, rodLayers, and firstLayerMm, which mode substrate also
// uses.
base::ParameterTable latheParameters();

} // namespace voluta::modes
