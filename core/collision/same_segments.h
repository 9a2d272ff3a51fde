// Which segments of a plan are another plan's too: most of them, where a few beads were moved or
// added.
#pragma once

#include "plan/tool_plan.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::collision {

inline constexpr std::uint32_t kNoSegment = std::numeric_limits<std::uint32_t>::max();

// Segments by their first waypoint. Per segment of `its`, the index in `of` (a list of `plan`'s) of
// one that fills the same, or kNoSegment; these indices rise. Not each that is there need be found:
// not those whose order changed. Throws Cancelled.
std::vector<std::uint32_t> sameSegments(const plan::ToolPlan& plan,
                                        const std::vector<std::uint32_t>& of,
                                        const plan::ToolPlan& itsPlan,
                                        const std::vector<std::uint32_t>& its,
                                        const base::RunContext& ctx);

} // namespace voluta::collision
