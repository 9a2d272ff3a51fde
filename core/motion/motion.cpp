#include "motion/motion.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "motion/change_place.h"
#include "motion/check.h"
#include "motion/external_axes.h"
#include "motion/head_refusals.h"
#include "motion/jerk_statistics.h"
#include "motion/ladder/path_planner.h"
#include "motion/ladder/size_in_reach.h"
#include "motion/lags.h"
#include "motion/layer_events.h"
#include "motion/nozzle_frame.h"
#include "motion/refusal_findings.h"
#include "motion/sequence.h"
#include "motion/sequence_times.h"
#include "motion/shot_events.h"
#include "motion/tape_events.h"
#include "motion/waits.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "process/bead_to.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <utility>

namespace voluta::motion {

using Eigen::Vector3d;

namespace {

// Rounds of planning again without waypoints that collide in the finished motion
constexpr int kRounds = 10;
// Rounds of planning transfers again because the arm waits on some of them
constexpr int kWaitRounds = 3;

double materialOf(const plan::ToolPlan& plan) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    if (path.kind != plan::PathKind::Shot)
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
        volume += process::beadTo(plan, i);
  return volume;
}

// Material that cannot be printed: the beads to and from waypoints that no motion reaches.
class Loss {
public:
  explicit Loss(const plan::ToolPlan& plan)
      : plan_(plan), planned_(materialOf(plan)), isLost_(plan.waypointCount(), 0) {}

  void add(const plan::ToolPath& path, std::size_t waypoint) {
    if (std::exchange(isLost_[waypoint], 1) || path.kind == plan::PathKind::Shot)
      return;
    if (waypoint > path.first && !isLost_[waypoint - 1])
      mm3_ += process::beadTo(plan_, waypoint);
    if (waypoint + 1 < path.first + path.count && !isLost_[waypoint + 1])
      mm3_ += process::beadTo(plan_, waypoint + 1);
  }
  bool exceeds(double share) const { return mm3_ > (share + kRounding) * planned_; }

private:
  static constexpr double kRounding = 1e-6;
  const plan::ToolPlan& plan_;
  double planned_, mm3_ = 0.0;
  std::vector<char> isLost_;
};

// Returns whether no other plan of the path can reach the waypoint.
bool isFinal(Refusal why) {
  return why != Refusal::NoConnection && why != Refusal::CloserLook && why != Refusal::None;
}

} // namespace

class MotionPlanner::Work {
public:
  Work(const plan::ToolPlan& plan, const robot::Cell& cell, const process::Tooling& tooling,
       const collision::GrowingPart& part, const MotionOptions& options)
      : plan_(plan), cell_(cell), tooling_(tooling), options_(options),
        // The cell has the head of the first tool.
        collision_(cell, tooling.first().process), scene_{plan, cell,     collision_,
                                                          part, options_, leversOf(plan, cell)},
        planner_(scene_, tooling), home_(stateAt(cell, cell.home())),
        places_(eventPlaces(plan, options.layerEvents)) {}

  MotionResult plan(const base::RunContext& ctx, double maxLeftOut) {
    base::Stopwatch watch;
    headBefore_ = headBefore(scene_.plan);
    homeMeets_ = contactAtHome();
    if (!homeMeets_)
      refusals_ = headRefusals(scene_, headBefore_, ctx.sub(0.0, 0.05));
    result_.times.collision += watch.seconds();

    ways_.resize(plan_.paths.size());
    if (homeMeets_)
      refuseAll(*homeMeets_);
    Loss loss(plan_);
    for (const plan::ToolPath& path : plan_.paths)
      for (std::size_t w = path.first; w < path.first + path.count; ++w)
        if (!homeMeets_ && refusals_[w] != Refusal::None)
          loss.add(path, w);
    for (std::size_t p = 0; p < plan_.paths.size() && !homeMeets_; ++p) {
      if (loss.exceeds(maxLeftOut))
        return givenUp(p);
      ctx.report(0.05 + 0.55 * static_cast<double>(plan_.paths[p].first) /
                            static_cast<double>(plan_.waypointCount()),
                 "motion"_text);
      planPath(p, ctx);
      // The motion of external axes depends on how a path is split: a different split may reach it.
      for (const Refused& r : ways_[p].refused)
        if (isFinal(r.why) && cell_.externalAxes().empty())
          loss.add(plan_.paths[p], r.waypoint);
    }
    if (!homeMeets_ && loss.exceeds(maxLeftOut))
      return givenUp(plan_.paths.size());
    return joined(ctx.sub(0.6, 1.0));
  }

  MotionResult planWithout(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx) {
    for (const std::size_t p : avoid(waypoints))
      planPath(p, ctx);
    return joined(ctx);
  }

private:
  // The planned runs and the refused waypoints of a path.
  struct PathRuns {
    std::vector<Run> runs;
    std::vector<Refused> refused;
  };

  // Returns findings only: the refusals of the planned paths, and the head's refusals of the
  // others.
  MotionResult givenUp(std::size_t plannedPaths) {
    std::vector<Refused> refused;
    for (std::size_t p = 0; p < plan_.paths.size(); ++p) {
      const plan::ToolPath& path = plan_.paths[p];
      if (p < plannedPaths)
        refused.insert(refused.end(), ways_[p].refused.begin(), ways_[p].refused.end());
      for (std::size_t w = path.first; p >= plannedPaths && w < path.first + path.count; ++w)
        if (refusals_[w] != Refusal::None)
          refused.push_back({w, refusals_[w], {}});
    }
    result_.findings = findingsOf(refused, scene_, [](std::size_t) { return 0.0; });
    result_.isGivenUp = true;
    return std::exchange(result_, {});
  }

  // Every motion begins and ends at home.
  std::optional<collision::Contact> contactAtHome() const {
    collision::CellCollision::Frames frames;
    cell_.framePoses(home_.q, frames);
    return collision_.bodies(frames, options_.travelling);
  }
  void refuseAll(const collision::Contact& contact) {
    refusals_.assign(plan_.waypointCount(), Refusal::Collision);
    for (std::size_t p = 0; p < plan_.paths.size(); ++p)
      for (std::size_t w = 0; w < plan_.paths[p].count; ++w)
        ways_[p].refused.push_back({plan_.paths[p].first + w, Refusal::Collision, contact});
  }

  // Marks these waypoints as refused and returns their paths, ascending, except for waypoints that
  // are left out already.
  std::vector<std::size_t> avoid(const std::vector<std::size_t>& waypoints) {
    std::set<std::size_t> paths;
    for (const std::size_t w : waypoints) {
      base::require(w < refusals_.size(), "waypoints of the plan, which is planned");
      if (refusals_[w] != Refusal::None)
        continue;
      refusals_[w] = Refusal::CloserLook;
      paths.insert(static_cast<std::size_t>(plan::pathOf(plan_, w) - plan_.paths.data()));
    }
    return {paths.begin(), paths.end()};
  }

  // Returns the waypoints towards which the finished motion collides. Collisions after the last
  // waypoint are not included.
  std::vector<std::size_t> collidingWaypoints() const {
    std::vector<std::size_t> waypoints;
    for (const TrajectoryCollision& c : check_.collisions)
      if (const std::size_t w = plan::waypointAhead(result_.trajectory, c.point);
          w != plan::kNoWaypoint)
        waypoints.push_back(w);
    return waypoints;
  }

  const RobotState& before(std::size_t path) const {
    while (path-- > 0)
      if (!ways_[path].runs.empty())
        return ways_[path].runs.back().points.back().at;
    return home_;
  }

  void planPath(std::size_t p, const base::RunContext& ctx) {
    const plan::ToolPath& path = plan_.paths[p];
    PathRuns built;
    const std::size_t end = path.first + path.count;
    for (std::size_t b = path.first, e = b; b < end; b = e) {
      if (refusals_[b] != Refusal::None) {
        built.refused.push_back({b, refusals_[b], {}});
        e = b + 1;
        continue;
      }
      for (e = b + 1; e < end && refusals_[e] == Refusal::None;)
        ++e;
      const RobotState& from = built.runs.empty() ? before(p) : built.runs.back().points.back().at;
      planner_.plan(p, b, e - b, from, ctx.quiet(), built.runs, built.refused);
    }
    ways_[p] = std::move(built);
  }

  // Joins the planned paths. Waypoints towards which the finished motion collides are left out, and
  // their paths are planned again.
  MotionResult joined(const base::RunContext& ctx) {
    join(ctx);
    for (int round = 0; round < kRounds; ++round) {
      const std::vector<std::size_t> paths = avoid(collidingWaypoints());
      if (paths.empty())
        break;
      for (const std::size_t p : paths)
        planPath(p, ctx);
      join(ctx);
    }
    const PathTimes paths = planner_.takeTimes();
    result_.times.ik += paths.ik;
    result_.times.graph += paths.graph;
    result_.times.jerk += paths.jerk;
    result_.times.collision += paths.collision;
    report(ctx);
    return std::exchange(result_, {});
  }

  void connect(const base::RunContext& ctx) {
    base::Stopwatch watch;
    std::vector<Run> runs;
    for (const PathRuns& built : ways_)
      runs.insert(runs.end(), built.runs.begin(), built.runs.end());
    ConnectedRuns connected = connectRuns(scene_, std::move(runs), home_, planner_, transfers_,
                                          ctx.sub(0.0, 0.5), waitBefore_);
    skipped_ = std::move(connected.skipped);
    refusedAgain_ = std::move(connected.refused);
    waitsAbovePart_ = connected.waitsAbovePart;
    result_.times.transfer += watch.seconds();

    watch = base::Stopwatch();
    assemble(connected.sequence, ctx.sub(0.5, 0.6));
    addCuts(result_.trajectory, plan_, tooling_);
    result_.times.jerk += watch.seconds();
  }

  // Adds the waits for beads to cool. Returns whether there are new ones.
  bool addWaits() {
    if (options_.minLayerTimeS <= 0.0)
      return false;
    plan::Trajectory& t = result_.trajectory;
    plan::MotionStatistics& s = result_.statistics;
    const std::size_t before = waitBefore_.size();
    for (const plan::TrajectoryEvent& wait : waitsToCool(plan_, t, cell_, options_.minLayerTimeS)) {
      t.events.push_back(wait);
      ++s.waits;
      s.waitS += wait.seconds;
      waitBefore_.insert(plan::waypointAhead(t, wait.point));
    }
    std::ranges::stable_sort(t.events, {}, &plan::TrajectoryEvent::point);
    s.durationS += s.waitS;
    return waitBefore_.size() > before;
  }

  // Connects, times and checks the planned paths.
  void join(const base::RunContext& ctx) {
    connect(ctx);
    // Travels on which the arm waits lift higher, which changes the waits.
    for (int round = 0; addWaits() && round < kWaitRounds; ++round)
      connect(ctx);

    const base::Stopwatch watch;
    ctx.report(0.6, "checking the motion"_text);
    check_ = checkTrajectory(result_.trajectory, scene_, headBefore_, kClearanceCapMm,
                             ctx.sub(0.6, 1.0));
    result_.times.collision += watch.seconds();
  }

  int toolOf(const Run& run) const { return plan_.paths[run.path].tool; }

  void assemble(const Sequence& sequence, const base::RunContext& ctx) {
    result_.trajectory = {};
    result_.trajectory.dof = cell_.dof();
    result_.statistics = {};
    result_.statistics.maxJerk.assign(static_cast<std::size_t>(cell_.dof()), 0.0);
    const std::size_t runs = sequence.runs.size(), ways = sequence.ways.size();
    const TimedSequence timed = timesOfSequence(sequence, scene_, tooling_, home_, ctx);

    if (runs > 0)
      result_.trajectory.firstTool = toolOf(sequence.runs.front());
    double time = 0.0, volume = 0.0;
    append(home_.q, 0.0, plan::MoveKind::Joint, plan::kNoWaypoint, 0.0);
    plan::MotionStatistics& s = result_.statistics;
    const auto appendTransfer = [&](std::size_t i) {
      const Transfer& transfer = sequence.ways[i];
      const int tool = i < runs ? toolOf(sequence.runs[i]) : 0;
      for (std::size_t k = 0; k < transfer.points.size(); ++k) {
        for (const ToolStep& step : transfer.toolSteps)
          if (step.point == k)
            changeTool(step, tool);
        const bool arrives = i < runs && k + 1 == transfer.points.size();
        append(transfer.points[k].at.q, time + timed.ways[i].times[k + 1], transfer.points[k].move,
               arrives ? sequence.runs[i].points.front().waypoint : plan::kNoWaypoint, volume);
      }
      time += timed.ways[i].times.back();
      ++s.transfers;
      s.arcTransfers += transfer.kind == TransferKind::Arc;
      s.jointTransfers += transfer.kind == TransferKind::Joint;
      s.treeTransfers += transfer.kind == TransferKind::Tree;
    };
    for (std::size_t i = 0; i < runs; ++i) {
      appendTransfer(i);
      const auto& points = sequence.runs[i].points;
      const std::size_t first = result_.trajectory.pointCount();
      const bool isShot = plan_.paths[sequence.runs[i].path].kind == plan::PathKind::Shot;
      const plan::MoveKind move = isShot ? plan::MoveKind::Linear : plan::MoveKind::Print;
      const std::optional<std::size_t> shot = shotPoint(plan_, sequence.runs[i]);
      for (std::size_t k = 1; k < points.size(); ++k) {
        volume += points[k].volumeMm3;
        append(points[k].at.q, time + timed.runs[i].times[k], move, points[k].waypoint, volume);
        if (shot == k)
          s.durationS +=
              addShotEvents(result_.trajectory, plan_.shotMm3(plan_.paths[sequence.runs[i].path]),
                            tooling_.at(toolOf(sequence.runs[i])).process, options_);
      }
      if (points.size() > 1 && !isShot)
        addLags(result_.trajectory, first, result_.trajectory.pointCount(),
                tooling_.at(toolOf(sequence.runs[i])).process.lag);
      time += timed.runs[i].times.back();
    }
    if (ways > runs)
      appendTransfer(runs);
    s.durationS += time + startLagsS(result_.trajectory);
    setJerk(timed, s);
  }

  // Adds the events of a step of the change to the tool, or that of a layer, before the motion to
  // the next point.
  void changeTool(const ToolStep& step, int tool) {
    using By = robot::ToolChange::By;
    const By by = cell_.toolChange().by;
    const auto add = [&](plan::TrajectoryEvent event) {
      event.point = result_.trajectory.pointCount();
      result_.trajectory.events.push_back(event);
      result_.statistics.durationS += event.seconds;
    };
    switch (step.kind) {
    case ToolStep::Kind::Release:
      add({.kind = plan::EventKind::Release, .seconds = robot::kChangerS});
      break;
    case ToolStep::Kind::Take:
      // The operator fits the tool before an output selects it.
      if (by == By::Hand)
        add({.kind = plan::EventKind::Pause});
      add({.kind = plan::EventKind::ToolChange, .tool = tool});
      ++result_.statistics.toolChanges;
      if (by == By::Changer)
        add({.kind = plan::EventKind::Lock, .seconds = robot::kChangerS});
      break;
    case ToolStep::Kind::Purge:
      if (const auto purge = purgeEvent(tooling_.at(tool).process, options_.purge.changeMm3))
        add(*purge);
      break;
    case ToolStep::Kind::Prime:
      if (const auto purge =
              purgeEvent(tooling_.at(tool).process, primeMm3(tooling_.at(tool).process)))
        add(*purge);
      break;
    case ToolStep::Kind::Event: {
      for (plan::TrajectoryEvent& event :
           trajectoryEvents(plan_, options_.layerEvents, places_.at(step.event)))
        add(std::move(event));
    }
    }
  }

  void append(const robot::JointVector& q, double time, plan::MoveKind move, std::size_t waypoint,
              double volume) {
    plan::Trajectory& t = result_.trajectory;
    t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
    t.timeS.push_back(time);
    t.move.push_back(move);
    t.waypoint.push_back(waypoint);
    t.extrudedMm3.push_back(volume);
  }

  void report(const base::RunContext& ctx) {
    plan::MotionStatistics& s = result_.statistics;
    const plan::Trajectory& t = result_.trajectory;
    std::vector<double> timeOf(plan_.waypointCount(), -1.0);
    for (std::size_t i = 0; i < t.pointCount(); ++i)
      if (t.waypoint[i] != plan::kNoWaypoint)
        timeOf[t.waypoint[i]] = t.timeS[i];
    s.waypoints = static_cast<std::size_t>(
        std::count_if(timeOf.begin(), timeOf.end(), [](double time) { return time >= 0.0; }));
    for (std::size_t w = 0; w < timeOf.size(); ++w)
      if (timeOf[w] < 0.0) {
        result_.skipped.push_back(w);
        timeOf[w] = w > 0 ? timeOf[w - 1] : 0.0; // When it would have been printed
      }
    s.minClearanceMm = check_.minClearanceMm;
    s.minClearanceAtS = t.timeS[check_.closestPoint];
    std::vector<Refused> refused;
    for (const PathRuns& built : ways_) {
      refused.insert(refused.end(), built.refused.begin(), built.refused.end());
      s.splits += built.runs.empty() ? 0 : built.runs.size() - 1;
    }
    refused.insert(refused.end(), refusedAgain_.begin(), refusedAgain_.end());
    for (const Refused& r : refused)
      if (r.why == Refusal::Unreachable || r.why == Refusal::NoConnection ||
          r.why == Refusal::BeyondRod || r.why == Refusal::Leans)
        ++s.unreachable;
      else
        ++s.collisions;
    for (const SkippedPiece& piece : skipped_)
      s.collisions += piece.waypoints.size();
    s.collisions += check_.collisions.size();
    const double planned = materialOf(plan_);
    const double deposited = t.extrudedMm3.empty() ? 0.0 : t.extrudedMm3.back();
    s.leftOutFraction = planned > 0.0 ? std::max(0.0, 1.0 - deposited / planned) : 0.0;

    const auto add = [&](plan::FindingKind kind, std::size_t waypoint, double when,
                         std::size_t count, std::vector<plan::NamedValue> values) {
      plan::Finding f = plan::makeFinding(kind, std::move(values), std::nullopt, count);
      if (waypoint < plan_.waypointCount())
        f.where = plan_.position[waypoint];
      f.whenS = when;
      result_.findings.push_back(std::move(f));
    };
    result_.findings = findingsOf(refused, scene_, [&](std::size_t w) { return timeOf[w]; });
    result_.tooLarge = tooLarge(refused, ctx);
    if (homeMeets_)
      result_.findings.insert(
          result_.findings.begin(),
          plan::makeFinding(plan::FindingKind::HomeMeets,
                            {{"first", collision_.nameOf(homeMeets_->first)},
                             {"second", collision_.nameOf(homeMeets_->second)}}));
    for (const bool caught : {false, true})
      addLost(caught, [&](const SkippedPiece& first, std::size_t waypoints, std::size_t pieces) {
        const std::size_t w = first.waypoints.front();
        add(caught ? plan::FindingKind::NoPathFrom : plan::FindingKind::NoPathTo, w, timeOf[w],
            waypoints, {{"place", placeOf(scene_, w)}, {"pieces", pieces}});
      });
    // Small gaps are reported but do not block; the replay judges their effect.
    if (s.leftOutFraction <= plan::kBlockingShare) {
      for (plan::Finding& f : result_.findings)
        f.blocking = false;
      if (!result_.skipped.empty())
        add(plan::FindingKind::LeftOut, result_.skipped.front(), timeOf[result_.skipped.front()],
            result_.skipped.size(),
            {{"share", base::percent(100.0 * s.leftOutFraction)},
             {"waypoints", result_.skipped.size()}});
    }
    if (std::optional<plan::Finding> jerk = jerkFinding(s, cell_, options_.maxJerk)) {
      const auto at = static_cast<std::size_t>(std::ranges::lower_bound(t.timeS, *jerk->whenS) -
                                               t.timeS.begin());
      if (const std::size_t w = plan::waypointAhead(t, std::min(at, t.pointCount() - 1));
          w < plan_.waypointCount())
        jerk->where = plan_.position[w];
      result_.findings.push_back(std::move(*jerk));
    }
    if (waitsAbovePart_ > 0)
      result_.findings.push_back(plan::makeFinding(plan::FindingKind::WaitsAbovePart,
                                                   {{"waits", waitsAbovePart_}}, std::nullopt,
                                                   waitsAbovePart_));
    if (std::optional<plan::Finding> shots = longShots(t, plan_))
      result_.findings.push_back(std::move(*shots));
    if (!check_.collisions.empty()) {
      const TrajectoryCollision& c = check_.collisions.front();
      add(plan::FindingKind::CollisionInMotion, plan::waypointAhead(t, c.point), t.timeS[c.point],
          check_.collisions.size(),
          {{"first", collision_.nameOf(c.contact.first)},
           {"second", collision_.nameOf(c.contact.second)}});
    }
  }

  std::optional<TooLarge> tooLarge(const std::vector<Refused>& refused,
                                   const base::RunContext& ctx) const {
    const auto unreached = std::ranges::count(refused, Refusal::Unreachable, &Refused::why);
    const double share = static_cast<double>(unreached) /
                         static_cast<double>(std::max<std::size_t>(plan_.waypointCount(), 1));
    if (share <= kTooLargeShare)
      return std::nullopt;
    return TooLarge{share, sizeInReach(scene_, refused, ctx)};
  }

  template <typename Add> void addLost(bool caught, const Add& add) const {
    const SkippedPiece* first = nullptr;
    std::size_t waypoints = 0, pieces = 0;
    for (const SkippedPiece& piece : skipped_)
      if (piece.caught == caught) {
        first = first ? first : &piece;
        waypoints += piece.waypoints.size();
        ++pieces;
      }
    if (first)
      add(*first, waypoints, pieces);
  }

  const plan::ToolPlan& plan_;
  const robot::Cell& cell_;
  const process::Tooling tooling_;
  const MotionOptions options_;
  collision::CellCollision collision_;
  MotionScene scene_;
  PathPlanner planner_;
  RobotState home_;
  KnownTransfers transfers_;
  std::vector<std::size_t> headBefore_;
  std::vector<Refusal> refusals_; // Of waypoints, before any path is planned
  std::vector<PathRuns> ways_;    // One per path
  std::optional<collision::Contact> homeMeets_;
  std::vector<SkippedPiece> skipped_; // For lack of a transfer
  std::vector<Refused> refusedAgain_; // Of runs that were planned again from another state
  std::set<std::size_t> waitBefore_;  // First waypoints of runs
  std::vector<EventPlace> places_;    // Of events of layers
  std::size_t waitsAbovePart_ = 0;    // ConnectedRuns::waitsAbovePart
  TrajectoryCheck check_;
  MotionResult result_;
};

MotionPlanner::MotionPlanner(const plan::ToolPlan& plan, const robot::Cell& cell,
                             const process::Tooling& tooling, const collision::GrowingPart& part,
                             const MotionOptions& options) {
  base::require(plan.direction.size() == plan.waypointCount() &&
                    plan.speedMmPerS.size() == plan.waypointCount(),
                "plan arrays of one length");
  base::require(options.samples >= 4, "at least four turns about the nozzle");
  for (const plan::ToolPath& path : plan.paths)
    base::require(path.count >= 1 && path.first + path.count <= plan.waypointCount(),
                  "paths inside the plan");
  work_ = std::make_unique<Work>(plan, cell, tooling, part, options);
}

MotionPlanner::~MotionPlanner() = default;

MotionResult MotionPlanner::plan(const base::RunContext& ctx, double maxLeftOut) {
  return work_->plan(ctx, maxLeftOut);
}

MotionResult MotionPlanner::planWithout(const std::vector<std::size_t>& waypoints,
                                        const base::RunContext& ctx) {
  return work_->planWithout(waypoints, ctx);
}

} // namespace voluta::motion
