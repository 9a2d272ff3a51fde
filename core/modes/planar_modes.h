// Modes "planar" (planar pieces) and "flat" (plain flat slicing).
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"
#include "planar/pieces.h"

#include <string>

namespace voluta::modes {

Mode planarMode();
Mode flatMode();

// Parameters overhangAngle, pieceMaterials, cutPlanes, adaptiveLayers, cuspMm, layerPlanes, and
// those of pieceSearchParameters().
base::ParameterTable planarModeParameters();

// Returns the rule that decides which faces of pieces are risky, i.e. need support.
planar::RiskRule riskRule(const ModeChoices& in);

// Returns the JSON text of `layerPlanes` or `cutPlanes`: the value itself if it is empty or JSON,
// otherwise the content of the file it names. Throws Error{UnreadableFile, UnusableInput} with the
// file's name if it is no such text.
std::string planesText(const std::string& value);

} // namespace voluta::modes
