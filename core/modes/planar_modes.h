// Planar pieces and plain flat slicing, as modes of the road.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"
#include "planar/pieces.h"

#include <string>

namespace voluta::modes {

Mode planarMode();
Mode flatMode();

// overhangAngle, pieceMaterials, cutPlanes, adaptiveLayers, cuspMm, layerPlanes, and those of
// pieceSearchParameters.
base::ParameterTable planarModeParameters();

// When faces of pieces need support.
planar::RiskRule riskRule(const ModeChoices& in);

// The text of `layerPlanes` or `cutPlanes`: planes as JSON as they are, else those in the file that
// it names. Throws Error{UnreadableFile}.
std::string planesText(const std::string& value);

} // namespace voluta::modes
