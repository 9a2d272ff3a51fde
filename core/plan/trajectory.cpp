#include "plan/trajectory.h"

#include <algorithm>

namespace voluta::plan {

std::span<const TrajectoryEvent> Trajectory::eventsBefore(std::size_t point) const {
  const auto range = std::ranges::equal_range(events, point, {}, &TrajectoryEvent::point);
  return {range.begin(), range.end()};
}

bool Trajectory::stopsBefore(std::size_t point) const {
  return std::ranges::any_of(eventsBefore(point),
                             [](const TrajectoryEvent& event) { return stopsArm(event.kind); });
}

double Trajectory::waitBefore(std::size_t point) const {
  double seconds = 0.0;
  for (const TrajectoryEvent& event : eventsBefore(point))
    seconds += event.seconds;
  return seconds;
}

double Trajectory::purgeBefore(std::size_t point) const {
  double mm3 = 0.0;
  for (const TrajectoryEvent& event : eventsBefore(point))
    mm3 += event.volumeMm3;
  return mm3;
}

bool Trajectory::shotBefore(std::size_t point) const {
  return std::ranges::any_of(eventsBefore(point), [](const TrajectoryEvent& event) {
    return event.kind == EventKind::Shot;
  });
}

bool Trajectory::changesTool(std::size_t after) const {
  return std::ranges::any_of(events, [&](const TrajectoryEvent& event) {
    return event.kind == EventKind::ToolChange && event.point > after;
  });
}

const TrajectoryEvent* Trajectory::changeAfter(const TrajectoryEvent& pause) const {
  const auto next = static_cast<std::size_t>(&pause - events.data()) + 1;
  const bool isForChange = pause.text.empty() && next < events.size() &&
                           events[next].point == pause.point &&
                           events[next].kind == EventKind::ToolChange;
  return isForChange ? &events[next] : nullptr;
}

int Trajectory::toolAt(std::size_t point) const {
  int tool = firstTool;
  for (const TrajectoryEvent& event : events)
    if (event.kind == EventKind::ToolChange && event.point <= point)
      tool = event.tool;
  return tool;
}

} // namespace voluta::plan
