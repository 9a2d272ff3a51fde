// Layers on a surface that is already there, as a mode of the road.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode substrateMode();

// layerShape, layerCentre, endSurface.
base::ParameterTable substrateParameters();

} // namespace voluta::modes
