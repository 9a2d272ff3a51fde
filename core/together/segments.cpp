#include "together/segments.h"

#include "base/error.h"

#include <algorithm>

namespace voluta::together {

namespace {
bool isTravel(const plan::Trajectory& t, std::size_t point) {
  return t.move[point] == plan::MoveKind::Linear || t.move[point] == plan::MoveKind::Joint;
}

// Whether the arm is lifted at the point: it travels to it and on from it.
bool isLifted(const plan::Trajectory& t, std::size_t point) {
  return point > 1 && point + 2 < t.pointCount() && isTravel(t, point) && isTravel(t, point + 1);
}

// Whether the point is amid a bead.
bool isInsideBead(const plan::Trajectory& t, std::size_t point) {
  return point + 1 < t.pointCount() && t.move[point] == plan::MoveKind::Print &&
         t.move[point + 1] == plan::MoveKind::Print;
}

std::vector<std::size_t> candidates(const plan::Trajectory& t, double insideBeadsS) {
  std::vector<std::size_t> points;
  double last = 0.0;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const bool isEnd = isLifted(t, i) && !(isLifted(t, i - 1) && isLifted(t, i + 1));
    if (!isEnd && !(isInsideBead(t, i) && t.timeS[i] - last >= insideBeadsS))
      continue;
    points.push_back(i);
    last = t.timeS[i];
  }
  return points;
}

// Keeps the rests that are furthest apart in time.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& rests, const plan::Trajectory& t,
                                 std::size_t maxCount) {
  if (rests.size() <= maxCount)
    return rests;
  const double apartS = t.timeS.back() / static_cast<double>(maxCount);
  std::vector<std::size_t> kept;
  double last = 0.0;
  for (const std::size_t i : rests)
    if (t.timeS[i] - last >= apartS) {
      kept.push_back(i);
      last = t.timeS[i];
    }
  return kept;
}
} // namespace

Rests restsOf(const plan::Trajectory& trajectory, std::size_t maxCount, double insideBeadsS,
              std::size_t printedBefore) {
  base::require(trajectory.pointCount() > 1, "restsOf: a motion");
  Rests rests;
  rests.point = {0};
  for (const std::size_t i : thinned(candidates(trajectory, insideBeadsS), trajectory, maxCount))
    rests.point.push_back(i);
  rests.point.push_back(trajectory.pointCount() - 1);
  std::size_t filled = printedBefore, next = 0;
  for (std::size_t i = 0; i < trajectory.pointCount(); ++i) {
    if (trajectory.move[i] == plan::MoveKind::Print && trajectory.waypoint[i] != plan::kNoWaypoint)
      filled = std::max(filled, trajectory.waypoint[i] + 1);
    while (next < rests.point.size() && rests.point[next] == i) {
      rests.filledFrom.push_back(filled);
      ++next;
    }
  }
  return rests;
}

std::vector<double> secondsOf(const plan::Trajectory& trajectory, const Rests& rests) {
  std::vector<double> seconds(rests.segments());
  for (std::size_t i = 0; i < seconds.size(); ++i)
    seconds[i] = trajectory.timeS[rests.point[i + 1]] - trajectory.timeS[rests.point[i]];
  for (const plan::TrajectoryEvent& event : trajectory.events) {
    const auto after = std::ranges::lower_bound(rests.point, event.point);
    if (after != rests.point.begin() && after != rests.point.end())
      seconds[static_cast<std::size_t>(after - rests.point.begin()) - 1] += event.seconds;
  }
  return seconds;
}

} // namespace voluta::together
