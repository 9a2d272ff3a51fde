#include "pipeline/slow_spans.h"

#include "plan/trajectory.h"

#include <algorithm>

namespace voluta::pipeline {

std::vector<SlowSpan> slowSpans(const plan::Trajectory& trajectory,
                                const std::vector<std::size_t>& pointOf,
                                const std::vector<double>& motionS) {
  std::vector<SlowSpan> spans;
  if (trajectory.pointCount() == 0)
    return spans;
  const double near = 1e-3 * trajectory.timeS.back();
  for (std::size_t m = 0; m < std::min(pointOf.size(), motionS.size()); ++m) {
    const std::size_t point = pointOf[m];
    if (point == 0 || point >= trajectory.pointCount())
      continue;
    const double from = trajectory.timeS[point - 1], to = trajectory.timeS[point];
    const double more = motionS[m] - (to - from);
    if (more <= kSlowShare * (to - from))
      continue;
    if (!spans.empty() && from >= spans.back().fromS && from - spans.back().toS <= near) {
      spans.back().toS = std::max(spans.back().toS, to);
      spans.back().moreS += more;
    } else {
      spans.push_back({from, to, more});
    }
  }
  return spans;
}

} // namespace voluta::pipeline
