// Mode "lathe": layers wound around a turning rod.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode latheMode();

// Parameters rodAxis, rodSides, rodProfile, rodLayers, and firstLayerMm, which modes flat, planar
// and substrate also use.
base::ParameterTable latheParameters();

} // namespace voluta::modes
