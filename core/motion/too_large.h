// Result for a part that is largely out of the robot's reach.
#pragma once

#include <optional>

namespace voluta::motion {

// Share of the waypoints. If more are out of reach, the part is too large as a whole.
inline constexpr double kTooLargeShare = 0.1;

struct TooLarge {
  double share = 0.0;         // share of the waypoints out of reach: more than kTooLargeShare
  std::optional<double> size; // share of its size at which the robot reaches it (size_in_reach.h)
};

} // namespace voluta::motion
