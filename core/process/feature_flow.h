// Range of a feature's flow: the factor of its beads' section.
#pragma once

namespace voluta::process {

inline constexpr double kLeastFlow = 0.5, kMostFlow = 2.0;

} // namespace voluta::process
