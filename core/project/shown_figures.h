// Figures of a replay as they are to be read.
#pragma once

#include "project/report.h"

namespace voluta::project {

// Returns the figures of the worst of several items, which decides; shares to 1e-4 and lengths to
// 1e-3 mm, away from a limit that they do not keep.
ReplayReport shownFigures(ReplayReport report);

} // namespace voluta::project
