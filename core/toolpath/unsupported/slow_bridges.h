// Slows beads down that bridge gaps.
#pragma once

#include "toolpath/unsupported/unsupported_pass.h"

namespace voluta::toolpath {

// Limits the speed of unsupported beads, and of the approach to and exit from them, to the bridging
// speed of their tool's process. The flow is scaled with the speed, as given by planned speeds and
// sections.
std::optional<PassResult> slowBridges(const UnsupportedBeads& beads, const SeenPart& part,
                                      const PassScene& scene, const base::RunContext& ctx);

} // namespace voluta::toolpath
