// Where a controller takes longer than was planned.
#pragma once

#include "plan/trajectory.h"

#include <cstddef>
#include <vector>

namespace voluta::pipeline {

// On the plan's clock, seconds; `moreS` is how much longer the controller takes for it.
struct SlowSpan {
  double fromS = 0.0, toS = 0.0, moreS = 0.0;
};

// `motionS`: the controller's seconds of each motion; `pointOf`: its point of the trajectory
// (replay::Verification). A motion is slow where its section would be off (replay/section_errors.h)
// if its flow were a rate, kSlowShare. Spans nearer to each other than a thousandth of the plan's
// time are one: finer is not seen.
inline constexpr double kSlowShare = 0.05;
std::vector<SlowSpan> slowSpans(const plan::Trajectory& trajectory,
                                const std::vector<std::size_t>& pointOf,
                                const std::vector<double>& motionS);

} // namespace voluta::pipeline
