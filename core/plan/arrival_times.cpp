#include "plan/arrival_times.h"

namespace voluta::plan {

std::vector<double> arrivalTimes(const Trajectory& trajectory) {
  std::vector<double> times = trajectory.timeS;
  double waited = 0.0;
  auto event = trajectory.events.begin();
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (; event != trajectory.events.end() && event->point <= i; ++event)
      waited += event->seconds;
    times[i] += waited;
  }
  return times;
}

} // namespace voluta::plan
