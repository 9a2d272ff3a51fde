// Mode "trace": beads of glue or sealant along curves on a body, which is the part.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

namespace voluta::modes {

Mode traceMode();

// Parameters traceAngle, traceInset, traceSpacing, tracePasses, traceSidePasses, traceSideDepth,
// traceFillLines, traceFillAngle and traceClosing.
base::ParameterTable traceParameters();

} // namespace voluta::modes
