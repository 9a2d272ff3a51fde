// Layers on a surface that is already there, as a mode of the road.
#pragma once

#include "base/parameters.h"
#include "pipeline/modes.h"

namespace voluta::pipeline {

Mode substrateMode();

// layerShape, layerCentre, endSurface.
base::ParameterTable substrateParameters();

} // namespace voluta::pipeline
