// Range of a feature's flow: the factor of its beads' section.
#pragma once

namespace voluta::process {

inline constexpr double kMinFlow = 0.5, kMaxFlow = 2.0;

} // namespace voluta::process
