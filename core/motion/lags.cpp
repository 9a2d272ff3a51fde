#include "motion/lags.h"

#include <cmath>

namespace voluta::motion {

void addLags(plan::Trajectory& trajectory, std::size_t first, std::size_t end,
             const process::ExtruderLag& lag) {
  if (lag.startS > 0.0)
    trajectory.events.push_back(
        {.point = first, .kind = plan::EventKind::StartLag, .seconds = lag.startS});
  if (lag.stopS <= 0.0)
    return;
  const std::vector<double>& timeS = trajectory.timeS;
  const auto error = [&](std::size_t point) {
    return std::abs(timeS[end - 1] - timeS[point - 1] - lag.stopS);
  };
  std::size_t stop = end - 1;
  while (stop > first && error(stop - 1) < error(stop))
    --stop;
  // A lag that is shorter than half the last motion ends with the bead.
  if (error(stop) < lag.stopS)
    trajectory.events.push_back({.point = stop, .kind = plan::EventKind::StopLag});
}

double startLagsS(const plan::Trajectory& trajectory) {
  double seconds = 0.0;
  for (const plan::TrajectoryEvent& event : trajectory.events)
    if (event.kind == plan::EventKind::StartLag)
      seconds += event.seconds;
  return seconds;
}

} // namespace voluta::motion
