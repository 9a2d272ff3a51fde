#include "together/machine_marks.h"

#include "base/error.h"
#include "plan/marks.h"

#include <algorithm>

namespace voluta::together {

std::vector<MarkPlace> marksOf(const Order& order, std::size_t machine, const Rests& rests) {
  std::vector<MarkPlace> marks;
  std::vector<std::size_t> others;
  for (const Rendezvous& r : order.meetings) {
    if (r.first != machine && r.second != machine)
      continue;
    const bool isFirst = r.first == machine;
    const std::size_t other = isFirst ? r.second : r.first;
    others.push_back(other);
    marks.push_back(
        {rests.point[isFirst ? r.firstRest : r.secondRest], plan::markLinkOf(machine, other)});
  }
  // By the lower and then by the higher number of both, which is ascending for each machine.
  std::ranges::sort(others);
  const auto repeated = std::ranges::unique(others);
  others.erase(repeated.begin(), repeated.end());
  std::vector<MarkPlace> starts;
  for (const std::size_t other : others)
    starts.push_back({rests.point.front(), plan::markLinkOf(machine, other)});
  marks.insert(marks.begin(), starts.begin(), starts.end());
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
        at, {.point = mark.point + 1, .kind = plan::EventKind::Mark, .tool = mark.link});
  }
  return marked;
}

} // namespace voluta::together
