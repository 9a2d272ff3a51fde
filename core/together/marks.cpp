#include "together/marks.h"

#include "base/error.h"
#include "plan/marks.h"

#include <algorithm>

namespace voluta::together {

std::vector<MarkPlace> marksOf(const Order& order, std::size_t machine, const Rests& rests) {
  std::vector<MarkPlace> marks;
  for (const Rendezvous& r : order.meetings)
    if (r.first == machine)
      marks.push_back({rests.point[r.firstRest], plan::markChannel(machine, r.second)});
    else if (r.second == machine)
      marks.push_back({rests.point[r.secondRest], plan::markChannel(machine, r.first)});
  return marks;
}

plan::Trajectory withMarks(const plan::Trajectory& trajectory,
                           const std::vector<MarkPlace>& marks) {
  base::require(std::ranges::is_sorted(marks, {}, &MarkPlace::point) &&
                    (marks.empty() || marks.back().point < trajectory.pointCount()),
                "withMarks: points of the trajectory");
  plan::Trajectory marked = trajectory;
  for (const MarkPlace& mark : marks) {
    auto at =
        std::ranges::lower_bound(marked.events, mark.point + 1, {}, &plan::TrajectoryEvent::point);
    while (at != marked.events.end() && at->point == mark.point + 1 &&
           at->kind == plan::EventKind::Mark)
      ++at;
    marked.events.insert(
        at, {.point = mark.point + 1, .kind = plan::EventKind::Mark, .tool = mark.channel});
  }
  return marked;
}

} // namespace voluta::together
