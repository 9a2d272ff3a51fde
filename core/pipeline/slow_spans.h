// Spans in which a controller takes longer than planned.
#pragma once

#include <cstddef>
#include <vector>

namespace voluta::plan {
struct Trajectory;
}

namespace voluta::pipeline {

// Times on the plan's clock [s]; `moreS`: the extra time of the controller.
struct SlowSpan {
  double fromS = 0.0, toS = 0.0, moreS = 0.0;
};

// Returns the spans in which the controller is slower than planned. `motionS`: the controller's
// time of each motion [s]; `pointOf`: its point of the trajectory (replay::Verification). A motion
// is slow if it takes longer by more than kSlowShare: with the flow as a rate its bead's section
// would then be off (replay/section_errors.h). Spans closer together than a thousandth of the
// plan's time are merged, as a finer resolution is not visible.
inline constexpr double kSlowShare = 0.05;
std::vector<SlowSpan> slowSpans(const plan::Trajectory& trajectory,
                                const std::vector<std::size_t>& pointOf,
                                const std::vector<double>& motionS);

} // namespace voluta::pipeline
