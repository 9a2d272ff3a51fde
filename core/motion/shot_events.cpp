#include "motion/shot_events.h"

#include "plan/finding_kinds.h"

#include <algorithm>

namespace voluta::motion {

std::optional<std::size_t> shotPoint(const plan::ToolPlan& plan, const Run& run) {
  const plan::ToolPath& path = plan.paths[run.path];
  if (path.kind != plan::PathKind::Shot)
    return std::nullopt;
  const auto at = std::ranges::find(run.points, plan.shotAt(path), &RunPoint::waypoint);
  if (at == run.points.end() || at + 1 == run.points.end())
    return std::nullopt;
  return static_cast<std::size_t>(at - run.points.begin());
}

double addShotEvents(plan::Trajectory& trajectory, double volumeMm3,
                     const process::Process& process, const MotionOptions& options) {
  // As short as possible: a long stay melts the layers around (Castelli 6.2).
  const double limit = process::flowLimit(process);
  const double flow =
      options.shot.flowMm3PerS > 0.0 ? std::min(options.shot.flowMm3PerS, limit) : limit;
  const std::size_t point = trajectory.pointCount();
  const double seconds = volumeMm3 / flow;
  trajectory.events.push_back(
      {.point = point, .kind = plan::EventKind::Shot, .seconds = seconds, .volumeMm3 = volumeMm3});
  if (options.shot.waitS > 0.0)
    trajectory.events.push_back(
        {.point = point, .kind = plan::EventKind::Wait, .seconds = options.shot.waitS});
  return seconds + std::max(0.0, options.shot.waitS);
}

std::optional<plan::Finding> longShots(const plan::Trajectory& trajectory,
                                       const plan::ToolPlan& plan) {
  std::size_t count = 0;
  double longest = kLongestShotS;
  std::optional<Eigen::Vector3d> at;
  const auto& events = trajectory.events;
  for (std::size_t e = 0; e < events.size(); ++e) {
    if (events[e].kind != plan::EventKind::Shot)
      continue;
    double seconds = events[e].seconds;
    if (e + 1 < events.size() && events[e + 1].kind == plan::EventKind::Wait &&
        events[e + 1].point == events[e].point)
      seconds += events[e + 1].seconds;
    if (seconds <= kLongestShotS)
      continue;
    ++count;
    if (seconds <= longest)
      continue;
    longest = seconds;
    const std::size_t waypoint = trajectory.waypoint[events[e].point - 1];
    if (waypoint < plan.waypointCount())
      at = plan.position[waypoint];
  }
  if (count == 0)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::LongShot,
                           {{"shots", count},
                            {"seconds", base::seconds(longest)},
                            {"most", base::seconds(kLongestShotS)}},
                           at, count);
}

} // namespace voluta::motion
