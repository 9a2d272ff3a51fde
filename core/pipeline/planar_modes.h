// Planar pieces and plain flat slicing, as modes of the road.
#pragma once

#include "base/parameters.h"
#include "pipeline/modes.h"

#include <string>

namespace voluta::pipeline {

Mode planarMode();
Mode flatMode();

// overhangAngle, adaptiveLayers, cuspMm, layerPlanes, pieceMaterials.
base::ParameterTable planarModeParameters();

// The text of `layerPlanes`: planes as JSON as they are, else those in the file that it names.
// Throws Error{UnreadableFile}.
std::string layerPlanesText(const std::string& value);

} // namespace voluta::pipeline
