// A part of which the robot gets to much too little.
#pragma once

#include <optional>

namespace voluta::motion {

// Of the waypoints. What more of them are out of reach is a part that is too large, not a place
// here and there.
inline constexpr double kTooLargeShare = 0.1;

struct TooLarge {
  double share = 0.0;         // of the waypoints, out of reach: more than kTooLargeShare
  std::optional<double> size; // of its size, at which the robot gets to it (size_in_reach.h)
};

} // namespace voluta::motion
