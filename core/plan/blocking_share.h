// The share of a print that may be left out before the plan is blocked.
#pragma once

namespace voluta::plan {

// Maximum share of the material, or of the waypoints, that may be left out. Leaving out more blocks
// the plan; less is only reported.
inline constexpr double kBlockingShare = 0.005;

} // namespace voluta::plan
