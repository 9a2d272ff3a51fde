#include "together/marks.h"

#include "base/error.h"

#include <algorithm>

namespace voluta::together {

namespace {
std::vector<std::size_t> pointsAt(const Schedule& schedule, const Rests& rests,
                                  std::size_t Phase::*from) {
  std::vector<std::size_t> points;
  for (std::size_t k = 1; k < schedule.phases.size(); ++k)
    points.push_back(rests.point[schedule.phases[k].*from]);
  return points;
}
} // namespace

std::vector<std::size_t> marksOfA(const Schedule& schedule, const Rests& rests) {
  return pointsAt(schedule, rests, &Phase::aFrom);
}
std::vector<std::size_t> marksOfB(const Schedule& schedule, const Rests& rests) {
  return pointsAt(schedule, rests, &Phase::bFrom);
}

plan::Trajectory withMarks(const plan::Trajectory& trajectory,
                           const std::vector<std::size_t>& points) {
  base::require(std::ranges::is_sorted(points) &&
                    (points.empty() || points.back() < trajectory.pointCount()),
                "withMarks: points of the trajectory");
  plan::Trajectory marked = trajectory;
  for (const std::size_t rest : points) {
    const auto at =
        std::ranges::lower_bound(marked.events, rest + 1, {}, &plan::TrajectoryEvent::point);
    marked.events.insert(at, {.point = rest + 1, .kind = plan::EventKind::Mark});
  }
  return marked;
}

} // namespace voluta::together
