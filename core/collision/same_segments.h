// Finds the segments that two plans have in common: most of them, if a few beads were moved or
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

// Segments are given by their first waypoint. Returns for each segment of `its` the index in `of`
// (of `plan`) of a segment that fills the same cells, or kNoSegment; these indices are increasing.
// The matching may be incomplete: segments whose order changed are not found. Throws Cancelled.
std::vector<std::uint32_t> sameSegments(const plan::ToolPlan& plan,
                                        const std::vector<std::uint32_t>& of,
                                        const plan::ToolPlan& itsPlan,
                                        const std::vector<std::uint32_t>& its,
                                        const base::RunContext& ctx);

} // namespace voluta::collision
