#include "motion/resumed_motion.h"

#include "base/error.h"
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/change_place.h"
#include "motion/external_axes.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"
#include "motion/sequence.h"
#include "motion/timed_points.h"
#include "motion/transfers/transfer.h"
#include "plan/output_states.h"
#include "plan/waypoints.h"

#include <algorithm>
#include <vector>

namespace voluta::motion {

namespace {

using plan::MoveKind;

robot::JointVector jointsAt(const plan::Trajectory& t, std::size_t point) {
  return Eigen::Map<const robot::JointVector>(t.at(point), t.dof);
}

void append(plan::Trajectory& to, const robot::JointVector& q, double time, MoveKind move,
            std::size_t waypoint, double volume) {
  to.joints.insert(to.joints.end(), q.data(), q.data() + q.size());
  to.timeS.push_back(time);
  to.move.push_back(move);
  to.waypoint.push_back(waypoint);
  to.extrudedMm3.push_back(volume);
}

// Returns the reversed transfer, from its end to `home`.
Transfer reversed(const Transfer& transfer, const RobotState& home) {
  Transfer back;
  back.kind = transfer.kind;
  for (std::size_t i = transfer.points.size(); i-- > 0;)
    back.points.push_back({i > 0 ? transfer.points[i - 1].at : home, transfer.points[i].move,
                           transfer.points[i].peakDisplacement});
  return back;
}

void appendTransfer(plan::Trajectory& to, const RobotState& from, const Transfer& transfer,
                    std::size_t arrivesAt, double speedMmPerS, const TimingLimits& limits) {
  const std::vector<double> times = timesOf(timedPoints(from, transfer, speedMmPerS), limits);
  const double start = to.timeS.back(), volume = to.extrudedMm3.back();
  for (std::size_t k = 0; k < transfer.points.size(); ++k)
    append(to, transfer.points[k].at.q, start + times[k + 1], transfer.points[k].move,
           k + 1 == transfer.points.size() ? arrivesAt : plan::kNoWaypoint, volume);
}

// Appends the trip on which the rest's nozzle is filled, away from the part printed so far: a purge
// if the tool may have been fitted just now, else a prime.
void purgeBeside(plan::Trajectory& to, const MotionScene& scene, const RobotState& home,
                 const process::Process& process, bool isChanged, std::size_t before,
                 const TimingLimits& limits, const base::RunContext& ctx) {
  const auto purge =
      purgeEvent(process, isChanged ? std::max(scene.options.purge.changeMm3, primeMm3(process))
                                    : primeMm3(process));
  if (!purge)
    return;
  const TransferPlanner planner(scene);
  const auto trip =
      purgeTrip(scene, home, purgePlaces(scene, home.q),
                [&](const RobotState& from, const RobotState& at, bool isStraight) {
                  return isStraight
                             ? planner.straight(from, at, before)
                             : planner.between(from, at, before, scene.options.seed + before, ctx);
                });
  const auto go = [&](const RobotState& from, const std::vector<TransferPoint>& points) {
    if (!points.empty())
      appendTransfer(to, from, {points}, plan::kNoWaypoint, process.travelSpeedMmPerS, limits);
  };
  if (trip)
    go(home, trip->there);
  to.events.push_back(*purge);
  to.events.back().point = to.pointCount();
  if (!trip)
    return;
  const RobotState at = trip->there.empty() ? home : trip->there.back().at;
  go(at, trip->wipe);
  go(trip->wipe.empty() ? at : trip->wipe.back().at, trip->back);
}

// Returns the times [s] from `point` for each point up to the end of its run, which starts from
// rest there.
std::vector<double> timesFromRest(const plan::Trajectory& t, std::size_t point, std::size_t end,
                                  const plan::ToolPlan& plan, const robot::Cell& cell,
                                  const TimingLimits& limits) {
  std::vector<RunPoint> run;
  for (std::size_t i = point; i < end; ++i) {
    RunPoint at{stateAt(cell, jointsAt(t, i)), t.waypoint[i], 0, 0.0, 0.0};
    at.next = plan::waypointAhead(t, i);
    if (i > point && at.next != plan::kNoWaypoint)
      at.speedMmPerS = plan.speedMmPerS[at.next];
    run.push_back(std::move(at));
  }
  return timesOf(timedPoints(cell, run), limits);
}

// Returns the pauses, waits and outputs before the bead that begins at the point, in their order:
// nobody knows which of them have been before the print stopped. The pause for a change of the tool
// is not among them, since the operator fits the tool before the rest. A rest that is taken up
// again has already repeated those before `resumedAt`.
std::vector<plan::TrajectoryEvent> eventsAhead(const plan::Trajectory& t, std::size_t point,
                                               std::size_t resumedAt) {
  using enum plan::EventKind;
  std::size_t printed = point; // the last point of the bead before
  while (printed > 0 && t.move[printed] != MoveKind::Print)
    --printed;
  std::vector<plan::TrajectoryEvent> ahead;
  for (const plan::TrajectoryEvent& event : t.events)
    if (event.point > printed && event.point >= resumedAt && event.point <= point &&
        (event.kind == Wait || event.kind == Output ||
         (event.kind == Pause && !t.changeAfter(event))))
      ahead.push_back(event);
  return ahead;
}

} // namespace

std::optional<std::size_t> resumePoint(const plan::Trajectory& t, std::size_t point) {
  const auto printsOn = [&](std::size_t p) {
    return p + 1 < t.pointCount() && t.move[p + 1] == MoveKind::Print;
  };
  std::size_t at = point;
  while (at < t.pointCount() && !printsOn(at))
    ++at;
  if (at >= t.pointCount())
    return std::nullopt;
  while (at > 0 && t.waypoint[at] == plan::kNoWaypoint && t.move[at] == MoveKind::Print)
    --at;
  return t.waypoint[at] == plan::kNoWaypoint ? std::nullopt : std::optional(at);
}

std::optional<std::size_t> resumePointOfPath(const plan::Trajectory& t, const plan::ToolPlan& plan,
                                             std::size_t path) {
  base::require(path < plan.paths.size(), "a path of the plan");
  const std::size_t first = plan.paths[path].first;
  for (std::size_t i = 0; i + 1 < t.pointCount(); ++i)
    if (t.move[i] != MoveKind::Print && t.move[i + 1] == MoveKind::Print &&
        t.waypoint[i] != plan::kNoWaypoint && t.waypoint[i] >= first)
      return i;
  return std::nullopt;
}

std::optional<std::size_t> resumePointOfBead(const plan::Trajectory& t, std::size_t point) {
  const auto next = resumePoint(t, point);
  if (!next)
    return std::nullopt;
  std::size_t begin = *next;
  while (begin > 0 && t.move[begin] == MoveKind::Print)
    --begin;
  return t.waypoint[begin] == plan::kNoWaypoint ? next : std::optional(begin);
}

std::size_t printedBefore(const plan::Trajectory& trajectory, std::size_t point) {
  std::size_t printed = 0;
  for (std::size_t i = 0; i < point; ++i)
    if (trajectory.move[i] == MoveKind::Print && trajectory.waypoint[i] != plan::kNoWaypoint)
      printed = std::max(printed, trajectory.waypoint[i] + 1);
  return printed;
}

plan::Trajectory partOf(const plan::Trajectory& t, std::size_t first, std::size_t last) {
  base::require(first < last && last <= t.pointCount(), "points of the trajectory");
  const auto span = [&](const auto& values, std::size_t each = 1) {
    return std::decay_t<decltype(values)>(
        values.begin() + static_cast<std::ptrdiff_t>(first * each),
        values.begin() + static_cast<std::ptrdiff_t>(last * each));
  };
  plan::Trajectory part;
  part.dof = t.dof;
  part.firstTool = t.toolAt(first);
  part.joints = span(t.joints, static_cast<std::size_t>(t.dof));
  part.timeS = span(t.timeS);
  part.move = span(t.move);
  part.waypoint = span(t.waypoint);
  part.extrudedMm3 = span(t.extrudedMm3);
  part.move.front() = MoveKind::Joint;
  for (const auto& [output, on] : plan::outputStates(t, first))
    part.events.push_back({.point = 0, .kind = plan::EventKind::Output, .tool = output, .on = on});
  for (plan::TrajectoryEvent event : t.events)
    // A mark may stand behind the last point.
    if (event.point > first && (event.point < last || event.point == t.pointCount())) {
      event.point -= first;
      part.events.push_back(event);
    }
  for (std::size_t i = 0; i < part.pointCount(); ++i) {
    part.timeS[i] -= t.timeS[first];
    part.extrudedMm3[i] -= t.extrudedMm3[first];
  }
  return part;
}

std::optional<Resumed> resumeAt(const plan::Trajectory& t, std::size_t point,
                                const plan::ToolPlan& plan, const robot::Cell& cell,
                                const process::Tooling& tooling, const collision::GrowingPart& part,
                                const MotionOptions& options, std::size_t resumedAt,
                                const base::RunContext& ctx) {
  base::require(point + 1 < t.pointCount() && t.move[point + 1] == MoveKind::Print &&
                    t.waypoint[point] < plan.waypointCount(),
                "a point at which printing goes on");
  constexpr int kThorough = 5; // Multiple of the usual search effort
  const std::size_t waypoint = t.waypoint[point];
  const auto path = static_cast<std::size_t>(plan::pathOf(plan, waypoint) - plan.paths.data());
  // Includes the whole path, so also the beads already printed by the interrupted run.
  const PrintedBounds surround = printedBoundsOf(plan)[path + 1];
  // The cell has the head of the first tool, and travels from and to home are as with that tool.
  const process::Process& first = tooling.first().process;
  const collision::CellCollision collision(cell, first);
  const MotionScene scene{plan, cell, collision, part, options, leversOf(plan, cell)};
  const RobotState start = stateAt(cell, jointsAt(t, point));
  const RobotState home = stateAt(cell, homeAfter(cell, start.q));

  std::optional<Transfer> transfer;
  for (const int effort : {1, kThorough})
    if (!transfer)
      transfer = TransferPlanner(scene, effort)
                     .approach(home, start, waypoint + 1, surround, options.seed + waypoint, ctx);
  if (!transfer)
    return std::nullopt;

  const TimingLimits limits = timingLimits(cell, first);
  Resumed resumed;
  plan::Trajectory& all = resumed.trajectory;
  all = partOf(t, 0, point + 1);
  appendTransfer(all, start, reversed(*transfer, home), plan::kNoWaypoint, first.travelSpeedMmPerS,
                 limits);
  resumed.firstPoint = all.pointCount();
  // The rest begins with the bead's own tool, which the operator fits before it starts.
  if (const int tool = plan.paths[path].tool; tool != all.toolAt(all.pointCount()))
    all.events.push_back(
        {.point = resumed.firstPoint, .kind = plan::EventKind::ToolChange, .tool = tool});
  append(all, home.q, all.timeS.back(), MoveKind::Joint, plan::kNoWaypoint, all.extrudedMm3.back());
  const std::vector<plan::TrajectoryEvent> again = t.move[point] == MoveKind::Print
                                                       ? std::vector<plan::TrajectoryEvent>()
                                                       : eventsAhead(t, point, resumedAt);
  bool isWaiting = false; // the nozzle drips meanwhile
  for (plan::TrajectoryEvent event : again) {
    isWaiting = isWaiting || event.kind != plan::EventKind::Output;
    event.point = all.pointCount();
    all.events.push_back(std::move(event));
  }
  if (isWaiting || !tooling.isOne() || (options.purge.primesBeside && dropsOnPart(scene, home.q)))
    purgeBeside(all, scene, home, tooling.of(plan.paths[path]).process, !tooling.isOne(),
                waypoint + 1, limits, ctx);
  appendTransfer(all, home, *transfer, waypoint, first.travelSpeedMmPerS, limits);

  std::size_t end = point + 1; // End of the run
  while (end < t.pointCount() && t.move[end] == MoveKind::Print)
    ++end;
  // An axis with steps has no acceleration limit, and its unstepped path is not stored, so its run
  // keeps the original times.
  const bool steps = std::any_of(cell.externalAxes().begin(), cell.externalAxes().end(),
                                 [](const robot::ExternalAxis& axis) { return axis.step > 0.0; });
  const bool cut = t.move[point] == MoveKind::Print && !steps;
  const std::vector<double> fromRest =
      cut ? timesFromRest(t, point, end, plan, cell,
                          timingLimits(cell, tooling.of(plan.paths[path]).process))
          : std::vector<double>();
  double shift = all.timeS.back() - t.timeS[point];
  const double begun = all.timeS.back();
  for (std::size_t i = point + 1; i < t.pointCount(); ++i) {
    const bool inCut = cut && i < end;
    const double time = inCut ? begun + fromRest[i - point] : t.timeS[i] + shift;
    append(all, jointsAt(t, i), time, t.move[i], t.waypoint[i], t.extrudedMm3[i]);
    if (inCut)
      shift = time - t.timeS[i];
  }
  // The points behind `point` keep their events. The extruder lags again where a bead goes on.
  const std::size_t offset = all.pointCount() - t.pointCount();
  const double lagS = tooling.of(plan.paths[path]).process.lag.startS;
  if (lagS > 0.0 && t.move[point] == MoveKind::Print)
    all.events.push_back(
        {.point = point + 1 + offset, .kind = plan::EventKind::StartLag, .seconds = lagS});
  for (plan::TrajectoryEvent event : t.events)
    if (event.point > point) {
      event.point += offset;
      all.events.push_back(event);
    }
  ctx.checkpoint();
  return resumed;
}

} // namespace voluta::motion
