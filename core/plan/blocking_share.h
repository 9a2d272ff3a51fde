// How much may stay unlaid.
#pragma once

namespace voluta::plan {

// Of the material, or of the waypoints: what more is left out blocks; less is told.
inline constexpr double kBlockingShare = 0.005;

} // namespace voluta::plan
