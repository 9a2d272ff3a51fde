// Walls, skins and interior of plane layers, as polygons.
#pragma once

#include "process/process.h"
#include "toolpath/options.h"
#include "toolpath/plane/plane_levels.h"

#include <cstddef>

namespace voluta::toolpath {

// [hatches]: the skin's edge rests on lines of the sparse infill below; narrower sparse parts are
// not worth their own lines.
inline constexpr double kSkinExtension = 1.5, kMinSparse = 3.0;

// Returns the number of layers of one thickness that a skin has.
int skinLayers(int layers, double skinMm, double thicknessMm);

// Returns the sparse part of a plane layer: inside its walls, and below and above as many layers as
// the options require. Skins extend into it by kSkinExtension; parts narrower than kMinSparse are
// left out. Precondition: levels.patch(index).
ClipperLib::Paths sparseArea(const PlaneLevels& levels, std::size_t index,
                             const process::Process& process, const ToolpathOptions& options);

} // namespace voluta::toolpath
