// Mode "substrate": layers on an existing surface.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode substrateMode();

// Parameters layerShape, layerCentre, endSurface.
base::ParameterTable substrateParameters();

} // namespace voluta::modes
