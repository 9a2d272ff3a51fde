#include "motion/motion.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/check.h"
#include "motion/head_refusals.h"
#include "motion/nozzle_frame.h"
#include "motion/path_planner.h"
#include "motion/refusal_findings.h"
#include "motion/rod_turn.h"
#include "motion/timing.h"
#include "motion/transfer.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::motion {

using Eigen::Vector3d;

namespace {

// Balls around what is printed before each path.
std::vector<Surround> surroundsOf(const plan::ToolPlan& plan) {
  std::vector<Surround> balls;
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero(); // the platform's middle
  for (const plan::ToolPath& path : plan.paths) {
    balls.push_back({0.5 * (low + high), 0.5 * (high - low).norm()});
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      low = low.cwiseMin(plan.position[i]);
      high = high.cwiseMax(plan.position[i]);
    }
  }
  balls.push_back({0.5 * (low + high), 0.5 * (high - low).norm()});
  return balls;
}

RobotState stateAt(const robot::Cell& cell, const robot::JointVector& q) {
  const Eigen::Isometry3d pose = cell.work_T_tool(q);
  return {pose.translation(), Eigen::Quaterniond(pose.linear()), q, rodAngle(cell, q)};
}

double radiusAboutRod(const plan::ToolPlan& plan) {
  double radius = 0.0;
  for (const Vector3d& p : plan.position)
    radius = std::max(radius, p.tail<2>().norm());
  return radius;
}

// Its steps are not the rod's acceleration: the motor takes them as they come on a smooth way.
robot::JointVector withoutSteps(const robot::Cell& cell, const RobotState& state) {
  robot::JointVector q = state.q;
  if (!cell.externalAxes().empty())
    q[cell.armDof()] = state.rodRad;
  return q;
}

std::vector<TimedPoint> timedPoints(const robot::Cell& cell, const std::vector<RunPoint>& points) {
  std::vector<TimedPoint> timed;
  timed.reserve(points.size());
  for (const RunPoint& p : points)
    timed.push_back({withoutSteps(cell, p.at), p.at.tip, p.speedMmPerS, false, false});
  return timed;
}

std::vector<TimedPoint> timedPoints(const RobotState& from, const Transfer& transfer,
                                    double speedMmPerS) {
  std::vector<TimedPoint> timed{{from.q, from.tip, speedMmPerS, false, true}};
  for (const TransferPoint& p : transfer.points) {
    const bool joint = p.move == plan::MoveKind::Joint;
    if (timed.size() > 1 && timed.back().jointMove != joint)
      timed.back().stop = true;
    timed.push_back({p.at.q, p.at.tip, speedMmPerS, joint, false});
  }
  return timed;
}

// Runs in order, with the way to each.
struct Sequence {
  std::vector<Run> runs;
  std::vector<Transfer> ways; // to runs[i]; one more: home again
};

class MotionPlanner {
public:
  MotionPlanner(const plan::ToolPlan& plan, const robot::Cell& cell,
                const process::Process& process, const collision::GrowingPart& part,
                const MotionOptions& options)
      : plan_(plan), cell_(cell), process_(process), options_(options),
        collision_(cell, process), scene_{plan, cell,    collision_,
                                          part, options, radiusAboutRod(plan)},
        planner_(scene_), surrounds_(surroundsOf(plan)), home_(stateAt(cell, cell.home())) {}

  MotionResult plan(const base::RunContext& ctx) {
    result_.trajectory.dof = cell_.dof();
    result_.statistics.maxJerk.assign(static_cast<std::size_t>(cell_.dof()), 0.0);
    base::Stopwatch watch;
    headBefore_ = headBefore(scene_.plan);
    const std::vector<Refusal> head = headRefusals(scene_, headBefore_, ctx.sub(0.0, 0.05));
    result_.times.collision += watch.seconds();

    Sequence sequence;
    sequence.runs = planRuns(head, ctx.sub(0.05, 0.6));
    watch = base::Stopwatch();
    connect(sequence, ctx.sub(0.6, 0.8));
    result_.times.transfer += watch.seconds();

    watch = base::Stopwatch();
    assemble(sequence, ctx.sub(0.8, 0.85));
    result_.times.jerk += watch.seconds();

    watch = base::Stopwatch();
    verify(ctx.sub(0.85, 1.0));
    result_.times.collision += watch.seconds();
    result_.times.ik += planner_.times().ik;
    result_.times.graph += planner_.times().graph;
    result_.times.collision += planner_.times().collision;
    report();
    return std::move(result_);
  }

private:
  std::vector<Run> planRuns(const std::vector<Refusal>& head, const base::RunContext& ctx) {
    std::vector<Run> runs;
    for (std::size_t p = 0; p < plan_.paths.size(); ++p) {
      const plan::ToolPath& path = plan_.paths[p];
      ctx.report(static_cast<double>(path.first) / static_cast<double>(plan_.waypointCount()),
                 "motion"_text);
      const std::size_t runsBefore = runs.size(), end = path.first + path.count;
      for (std::size_t b = path.first, e = b; b < end; b = e) {
        if (head[b] != Refusal::None) {
          refused_.push_back({b, head[b], {}});
          e = b + 1;
          continue;
        }
        for (e = b + 1; e < end && head[e] == Refusal::None;)
          ++e;
        const RobotState& from = runs.empty() ? home_ : runs.back().points.back().at;
        planner_.plan(p, b, e - b, from, ctx, runs, refused_);
      }
      if (runs.size() > runsBefore)
        result_.statistics.splits += runs.size() - runsBefore - 1;
    }
    return runs;
  }

  // Fills in the ways; runs that cannot be come to are taken out and refused.
  void connect(Sequence& sequence, const base::RunContext& ctx) {
    const TransferPlanner planner(scene_);
    std::vector<Run>& runs = sequence.runs;
    const auto wayBetween = [&](const Run& a, const Run& b) {
      const RunPoint &last = a.points.back(), &first = b.points.front();
      const plan::ToolPath &pathA = plan_.paths[a.path], &pathB = plan_.paths[b.path];
      const bool hop = pathA.layer == pathB.layer && pathA.patch == pathB.patch &&
                       (last.at.tip - first.at.tip).norm() <= options_.hopMm;
      return planner.plan(last.at, first.at, hop, first.next, surrounds_[b.path],
                          options_.seed + first.next, ctx);
    };
    std::vector<std::optional<Transfer>> found(runs.size());
    if (!runs.empty())
      base::parallelChunks(ctx, runs.size() - 1, 1, [&](std::size_t b, std::size_t) {
        found[b + 1] = wayBetween(runs[b], runs[b + 1]);
      });
    ctx.checkpoint();

    // Where no way leads on, the arm goes home with what is printed by then, and on from there.
    Sequence kept;
    std::optional<Transfer> parked; // the way home from the last kept run, once it was needed
    const auto homeFrom = [&](const Run& run) {
      return stateAt(cell_, homeAfter(cell_, run.points.back().at.q));
    };
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const RunPoint& first = runs[r].points.front();
      const Surround& surround = surrounds_[runs[r].path];
      const std::uint64_t seed = options_.seed + first.next;
      std::optional<Transfer> way;
      if (kept.runs.empty()) {
        way = planner.approach(home_, first.at, first.next, surround, seed, ctx);
      } else if (!parked) {
        way = std::move(found[r]); // from run r - 1, which is the last kept one
        if (!way)
          parked = planner.leave(kept.runs.back().points.back().at, homeFrom(kept.runs.back()),
                                 first.next, surround, seed, ctx);
      }
      if (!way && parked &&
          (way = planner.approach(homeFrom(kept.runs.back()), first.at, first.next, surround, seed,
                                  ctx))) {
        way->points.insert(way->points.begin(), parked->points.begin(), parked->points.end());
        parked.reset();
      }
      if (!way) {
        ++blockedRuns_;
        for (const RunPoint& p : runs[r].points)
          if (p.waypoint != plan::kNoWaypoint)
            unapproached_.push_back(p.waypoint);
        // What follows cannot lead on from a run that is not there.
        if (!parked && !kept.runs.empty() && r + 1 < runs.size())
          found[r + 1] = wayBetween(kept.runs.back(), runs[r + 1]);
        continue;
      }
      kept.ways.push_back(std::move(*way));
      kept.runs.push_back(std::move(runs[r]));
    }
    if (!kept.runs.empty()) {
      if (!parked)
        parked = planner.leave(kept.runs.back().points.back().at, homeFrom(kept.runs.back()),
                               plan_.waypointCount(), surrounds_.back(), options_.seed, ctx);
      if (parked)
        kept.ways.push_back(std::move(*parked));
      else
        stranded_ = true;
    }
    sequence = std::move(kept);
  }

  void assemble(const Sequence& sequence, const base::RunContext& ctx) {
    TimingLimits limits;
    limits.joints = cell_.limits();
    limits.accelerationMmPerS2 = process_.accelerationMmPerS2;
    limits.arm = cell_.armDof();
    const std::size_t runs = sequence.runs.size(), ways = sequence.ways.size();
    std::vector<std::vector<double>> runTimes(runs), wayTimes(ways);
    std::vector<JerkMeasure> jerks(runs), jerksBefore(runs);
    base::parallelChunks(ctx, std::max(runs, ways), 4, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i) {
        if (i < runs) {
          const auto points = timedPoints(cell_, sequence.runs[i].points);
          runTimes[i] = timesOf(points, limits);
          jerks[i] = jerkOf(points, runTimes[i]);
          const auto before = timedPoints(cell_, sequence.runs[i].ladder);
          jerksBefore[i] = jerkOf(before, timesOf(before, limits));
        }
        if (i < ways) {
          const RobotState& from = i == 0 ? home_ : sequence.runs[i - 1].points.back().at;
          wayTimes[i] =
              timesOf(timedPoints(from, sequence.ways[i], process_.travelSpeedMmPerS), limits);
        }
      }
    });

    double time = 0.0, volume = 0.0;
    append(home_.q, 0.0, plan::MoveKind::Joint, plan::kNoWaypoint, 0.0);
    MotionStatistics& s = result_.statistics;
    const auto appendWay = [&](std::size_t i) {
      const Transfer& way = sequence.ways[i];
      for (std::size_t k = 0; k < way.points.size(); ++k) {
        const bool arrives = i < runs && k + 1 == way.points.size();
        append(way.points[k].at.q, time + wayTimes[i][k + 1], way.points[k].move,
               arrives ? sequence.runs[i].points.front().waypoint : plan::kNoWaypoint, volume);
      }
      time += wayTimes[i].back();
      ++s.transfers;
      s.arcTransfers += way.kind == TransferKind::Arc;
      s.jointTransfers += way.kind == TransferKind::Joint;
      s.treeTransfers += way.kind == TransferKind::Tree;
    };
    for (std::size_t i = 0; i < runs; ++i) {
      appendWay(i);
      const auto& points = sequence.runs[i].points;
      for (std::size_t k = 1; k < points.size(); ++k) {
        volume += points[k].volumeMm3;
        append(points[k].at.q, time + runTimes[i][k], plan::MoveKind::Print, points[k].waypoint,
               volume);
      }
      time += runTimes[i].back();
      s.sumSquaredJerk += jerks[i].sumSquared;
      s.sumSquaredJerkBefore += jerksBefore[i].sumSquared;
      for (std::size_t j = 0; j < s.maxJerk.size(); ++j)
        s.maxJerk[j] = std::max(s.maxJerk[j], jerks[i].maxAbs[j]);
    }
    if (ways > runs)
      appendWay(runs);
    s.durationS = time;
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

  void verify(const base::RunContext& ctx) {
    ctx.report(0.0, "checking the motion"_text);
    check_ = checkTrajectory(result_.trajectory, scene_, headBefore_, kClearanceCapMm, ctx);
    result_.statistics.minClearanceMm = check_.minClearanceMm;
  }

  void report() {
    MotionStatistics& s = result_.statistics;
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
        timeOf[w] = w > 0 ? timeOf[w - 1] : 0.0; // when it would have been its turn
      }
    for (const Refused& r : refused_)
      if (r.why == Refusal::Unreachable || r.why == Refusal::NoConnection ||
          r.why == Refusal::BeyondRod)
        ++s.unreachable;
      else
        ++s.collisions;
    s.collisions += unapproached_.size() + check_.collisions.size();

    result_.findings = findingsOf(refused_, scene_, [&](std::size_t w) { return timeOf[w]; });
    const auto add = [&](plan::FindingKind kind, std::size_t waypoint, double when,
                         std::size_t count, std::vector<plan::NamedValue> values) {
      plan::Finding f = plan::makeFinding(kind, std::move(values), std::nullopt, count);
      if (waypoint < plan_.waypointCount())
        f.where = plan_.position[waypoint];
      f.whenS = when;
      result_.findings.push_back(std::move(f));
    };
    if (!unapproached_.empty())
      add(plan::FindingKind::NoWayTo, unapproached_.front(), timeOf[unapproached_.front()],
          unapproached_.size(),
          {{"place", placeOf(scene_, unapproached_.front())}, {"pieces", blockedRuns_}});
    if (stranded_)
      add(plan::FindingKind::NoWayHome, plan_.waypointCount(), s.durationS, 1, {});
    if (!check_.collisions.empty()) {
      const TrajectoryCollision& c = check_.collisions.front();
      std::size_t waypoint = plan::kNoWaypoint;
      for (std::size_t i = c.point; i < t.pointCount() && waypoint == plan::kNoWaypoint; ++i)
        waypoint = t.waypoint[i];
      add(plan::FindingKind::CollisionInMotion, waypoint, t.timeS[c.point],
          check_.collisions.size(),
          {{"first", collision_.nameOf(c.contact.first)},
           {"second", collision_.nameOf(c.contact.second)}});
    }
  }

  const plan::ToolPlan& plan_;
  const robot::Cell& cell_;
  const process::Process& process_;
  const MotionOptions& options_;
  collision::CellCollision collision_;
  MotionScene scene_;
  PathPlanner planner_;
  std::vector<Surround> surrounds_; // a path
  RobotState home_;
  std::vector<std::size_t> headBefore_;
  std::vector<Refused> refused_;
  std::size_t blockedRuns_ = 0;           // without a way to them
  std::vector<std::size_t> unapproached_; // their waypoints
  bool stranded_ = false;                 // no way home
  TrajectoryCheck check_;
  MotionResult result_;
};

} // namespace

MotionResult planMotion(const plan::ToolPlan& plan, const robot::Cell& cell,
                        const process::Process& process, const collision::GrowingPart& part,
                        const MotionOptions& options, const base::RunContext& ctx) {
  base::require(plan.direction.size() == plan.waypointCount() &&
                    plan.speedMmPerS.size() == plan.waypointCount(),
                "plan arrays of one length");
  base::require(options.samples >= 4, "at least four turns about the nozzle");
  for (const plan::ToolPath& path : plan.paths)
    base::require(path.count >= 1 && path.first + path.count <= plan.waypointCount(),
                  "paths inside the plan");
  return MotionPlanner(plan, cell, process, part, options).plan(ctx);
}

} // namespace voluta::motion
