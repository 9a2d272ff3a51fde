// Planar pieces and plain flat slicing, as modes of the road.
#pragma once

#include "base/parameters.h"
#include "pipeline/modes.h"

#include <string>

namespace voluta::pipeline {

Mode planarMode();
Mode flatMode();

// overhangAngle, pieceMaterials, cutPlanes, adaptiveLayers, cuspMm, layerPlanes.
base::ParameterTable planarModeParameters();

// The text of `layerPlanes` or `cutPlanes`: planes as JSON as they are, else those in the file that
// it names. Throws Error{UnreadableFile}.
std::string planesText(const std::string& value);

} // namespace voluta::pipeline
