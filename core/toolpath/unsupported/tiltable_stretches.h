// Stretches of unsupported beads that can be pressed against their neighbours.
#pragma once

#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/unsupported/bridges.h"

#include <vector>

namespace voluta::toolpath {

// Where a layer begins at a chin or on a rim, it overhangs the printed part by several beads, of
// which only the innermost is supported. An arm tilted outwards presses each bead against its inner
// neighbour (tilt_unsupported.h), which therefore has to be printed first (order_inside_out.h).

// Returns whether a plan is upright throughout except for supports (flat layers). Such plans are
// not tilted: their cell, or the reader of their program, may support no tilt.
bool isUpright(const plan::ToolPlan& plan);

// Returns the stretches of a path that have to be printed last and tilted: those longer than half
// of the bridge length of its tool's process. Supports have none.
std::vector<UnsupportedStretch> tiltableStretches(const plan::ToolPlan& plan,
                                                  const plan::ToolPath& path,
                                                  const std::vector<char>& unsupported,
                                                  const process::Tooling& tooling);

} // namespace voluta::toolpath
