// The speeds by feature as parameters, which replace those of the process's file.
#pragma once

#include "base/parameters.h"
#include "process/features.h"

namespace voluta::process {

// Returns the parameters outerWallSpeedMmPerS, innerWallSpeedMmPerS, infillSpeedMmPerS,
// supportSpeedMmPerS and firstLayerSpeedMmPerS; 0, the default: as in the process's file.
base::ParameterTable featureParameters();

// Sets the speeds that are not 0. Precondition: the values have the parameters above.
void setFeatureSpeeds(FeatureTable& features, const base::ParameterValues& values);

} // namespace voluta::process
