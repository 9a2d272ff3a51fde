#include "motion/ladder/path_planner.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/external_axes.h"
#include "motion/ladder/branch_blend.h"
#include "motion/ladder/divided_step.h"
#include "motion/ladder/joint_costs.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/even_turns.h"
#include "motion/smoothing/local_filter.h"
#include "motion/smoothing/smooth_run.h"
#include "motion/timed_points.h"
#include "process/bead_to.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr int kTries = 40; // Rounds of blocking failed nodes and searching again
constexpr int kSeeks = 2;  // Searches for a path with more clearance
constexpr int kTriesBeforeJudgingAll = 6;
constexpr double kEvening = 200.0; // Removes waves shorter than about 24 waypoints
constexpr std::size_t kCheckChunk = 16;

// A waypoint at which, or on the motion to which, a run fails.
struct Failed {
  std::size_t waypoint;
  bool passes; // The only failure is passing a singular pose
};

// The unplanned rest of a path: as much of it as can be connected becomes a run.
class Stretch {
public:
  Stretch(const RunSmoothing& smoothing, std::size_t path, std::size_t first, std::size_t count,
          const RobotState& from, const base::RunContext& ctx, PathTimes& times)
      : smoothing_(smoothing), scene_(smoothing.scene), ctx_(ctx), times_(times), first_(first),
        ladder_(scene_, first, count, from, ctx, times), count_(ladder_.followed()) {
    run_.path = path;
  }

  // Appends a run, or refused waypoints; returns the number of waypoints handled (>= 1).
  std::size_t plan(std::vector<Run>& runs, std::vector<Refused>& refused);

private:
  // Handles a path that does not connect all rungs: adds nodes or rungs to extend it, or gives up
  // the rest. Returns false if there is no path and nothing more to try.
  bool goFurther(const LadderPath& ladderPath);
  std::size_t refuseStart(const LadderPath& ladderPath, std::vector<Refused>& refused);
  // Fills run_ along a path over all rungs. Returns the failures; empty if the run is valid.
  std::vector<Failed> follow(const LadderPath& ladderPath);
  // Smooths a run without collisions; its ends stay.
  void smooth();
  // Lowers the greatest jerks of a run whose rotations were evened.
  void filterJerk();
  // Returns whether the head, lifted by the minimum of the shortest travel, has room to travel.
  bool headTravels(const RobotState& state, std::size_t before) const;
  // Returns whether the nozzle can be lifted at both ends. Blocks their nodes where it cannot:
  // false requires another path.
  bool endsLift();
  // Keeps the part before the first failure. Returns false if that part is empty.
  bool settle(std::size_t failed);
  // Checks the rungs around each failure; adds rungs where the path's own nodes are free of
  // collisions.
  void lookCloser(const LadderPath& ladderPath, const std::vector<Failed>& failed, bool judgeAll);

  // Computes the points of waypoints [first, first + course.turn.size()), divided where the nozzle
  // would deviate from its straight line. Returns false if the joints cannot follow; failedAt is
  // that waypoint.
  bool fill(const Course& course, const JointVector& start, std::vector<RunPoint>& points,
            std::size_t& failedAt) const;
  std::vector<Failed> failures(const std::vector<RunPoint>& points) const;

  const RunSmoothing& smoothing_;
  const MotionScene& scene_;
  const base::RunContext& ctx_;
  PathTimes& times_;
  std::size_t first_;
  PathLadder ladder_;
  std::size_t count_;
  Run run_;
  std::vector<RunPoint> unsmoothed_; // run_ with the unsmoothed rotations of the ladder
  bool wantsLift_ = true;            // At both ends
};

bool Stretch::fill(const Course& course, const JointVector& start, std::vector<RunPoint>& points,
                   std::size_t& failedAt) const {
  const plan::ToolPlan& plan = scene_.plan;
  points.clear();
  points.reserve(course.rotation.size()); // Most steps are not divided
  std::vector<JointVector> scratch;
  const auto toolAt = [&](std::size_t i) {
    return turned(ladder_.toolAt(i), course.rotation[i - first_]);
  };
  const auto axesTo = [&](std::size_t i) { return ladder_.axesAt(i, course.offset[i - first_]); };
  JointVector q;
  // With smoothed rotations, the first solution may differ from the ladder's.
  if (!solveNear(scene_.cell, plan.position[first_], toolAt(first_), start, kRungStepRad, scratch,
                 q)) {
    failedAt = first_;
    return false;
  }
  points.push_back(
      {{plan.position[first_], toolAt(first_), q, axesTo(first_)}, first_, first_, 0.0, 0.0});
  for (std::size_t i = first_ + 1; i < first_ + course.rotation.size(); ++i) {
    const Quaterniond from = toolAt(i - 1), to = toolAt(i);
    const Vector3d a = plan.position[i - 1], b = plan.position[i];
    const int n = scene_.divisions(a, b, angleBetween(from, to));
    const double volume =
        plan.paths[run_.path].kind == plan::PathKind::Shot ? 0.0 : process::beadTo(plan, i);
    const RunPoint next{
        {b, to, {}, axesTo(i)}, i, i, volume, static_cast<double>(plan.speedMmPerS[i])};
    if (!appendDivided(scene_, next, n, points)) {
      failedAt = i;
      return false;
    }
  }
  return true;
}

std::vector<Failed> Stretch::failures(const std::vector<RunPoint>& points) const {
  enum : char { kSound, kPasses, kMeets };
  std::vector<char> bad(points.size(), kSound);
  base::parallelChunks(ctx_, points.size(), kCheckChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e; ++p)
      if (ladder_.contactAt(points[p].at.q, points[p].next))
        bad[p] = kMeets;
      else if (p > 0 && !scene_.movesStraight(points[p - 1].at, points[p].at))
        bad[p] = kPasses;
  });
  std::vector<Failed> failed;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (bad[p] != kSound) {
      if (failed.empty() || failed.back().waypoint != points[p].next)
        failed.push_back({points[p].next, true});
      failed.back().passes = failed.back().passes && bad[p] == kPasses;
    }
  return failed;
}

bool Stretch::goFurther(const LadderPath& ladderPath) {
  if (ladder_.widen(ladderPath.reached, ctx_))
    return true;
  // A run that is hard to depart from is better than none.
  if (wantsLift_ && ladder_.allowUnliftable()) {
    wantsLift_ = false;
    return true;
  }
  if (ladderPath.reached == 0)
    return false;
  if (ladder_.refine(ladderPath.reached, ctx_))
    return true;
  if (ladderPath.reached == 1)
    return false;
  // The connected part is printed, and the rest starts again.
  ladder_.keepUpTo(ladderPath.reached - 1, ctx_);
  count_ = ladder_.waypointOf(ladderPath.reached - 1) - first_ + 1;
  return true;
}

std::size_t Stretch::refuseStart(const LadderPath& ladderPath, std::vector<Refused>& refused) {
  if (ladderPath.reached == 0) {
    if (ladder_.movesPart())
      return ladder_.refuseBlocked(ctx_, refused);
    ladder_.judge({0}, ctx_); // To find the reason
  }
  refused.push_back(ladder_.refusalOf(0));
  return 1;
}

std::vector<Failed> Stretch::follow(const LadderPath& ladderPath) {
  base::Stopwatch watch;
  const Course course = ladder_.courseOf(ladderPath);
  // On a rod the nozzle often need not rotate at all.
  const bool uneven =
      !ladder_.movesPart() || std::any_of(course.rotation.begin(), course.rotation.end(),
                                          [&](double t) { return t != course.rotation.front(); });
  const bool evens = uneven && scene_.options.smoothing == SmoothingMethod::Evened;
  bool followed = false, even = false;
  std::size_t failedAt = 0;
  base::parallelChunks(ctx_, evens ? 2 : 1, 1, [&](std::size_t which, std::size_t) {
    if (which == 0) {
      followed = fill(course, ladderPath.q.front(), unsmoothed_, failedAt);
    } else {
      std::size_t anywhere = 0;
      even = fill({evened(course.rotation, kEvening), course.offset}, ladderPath.q.front(),
                  run_.points, anywhere);
    }
  });
  times_.ik += watch.seconds();
  if (!followed)
    return {{failedAt, false}};
  watch = base::Stopwatch();
  std::vector<Failed> failed;
  if (!even || !failures(run_.points).empty()) {
    run_.points = unsmoothed_;
    failed = failures(run_.points);
  }
  times_.collision += watch.seconds();
  return failed;
}

void Stretch::smooth() {
  if (scene_.options.rotation != NozzleRotation::Free)
    return;
  if (scene_.options.smoothing != SmoothingMethod::WholePath) {
    if (scene_.options.smoothing == SmoothingMethod::Evened && scene_.options.maxJerk > 0.0)
      filterJerk();
    return;
  }
  SmoothedRun smoothed = smoothRun(
      smoothing_, unsmoothed_,
      [&](const JointVector& q, std::size_t w) { return ladder_.contactAt(q, w).has_value(); },
      [&](const RobotState& state, bool last) {
        const std::size_t before = first_ + (last ? count_ : 0);
        return ladder_.liftable(state, before) && headTravels(state, before);
      },
      ctx_);
  // Reject rotations that take the arm past a singular pose.
  bool straight = true;
  for (std::size_t p = 1; p < smoothed.points.size() && straight; ++p)
    straight = scene_.movesStraight(smoothed.points[p - 1].at, smoothed.points[p].at);
  if (straight) {
    run_.points = std::move(smoothed.points);
    unsmoothed_ = std::move(smoothed.before);
  }
  times_.jerk += smoothed.smoothS;
  times_.collision += smoothed.checkS;
}

void Stretch::filterJerk() {
  const base::Stopwatch watch;
  run_.points = filteredRun(
      smoothing_, std::move(run_.points),
      [&](const JointVector& q, std::size_t w) { return ladder_.contactAt(q, w).has_value(); },
      scene_.options.maxJerk, {}, ctx_);
  times_.jerk += watch.seconds();
}

bool Stretch::headTravels(const RobotState& state, std::size_t before) const {
  const MotionOptions& options = scene_.options;
  for (const double height : {options.hopLiftMm, options.liftMm}) {
    const Eigen::Isometry3d lifted = toolPose(state.tip + height * state.direction(), state.tool);
    if (scene_.collision.headTouchesPart(lifted, scene_.part, before, options.travelling.headMm) ||
        scene_.collision.headTouchesPlatform(lifted, options.travelling.headMm))
      return false;
  }
  return true;
}

bool Stretch::endsLift() {
  const std::size_t last = ladder_.size() - 1;
  const RunPoint &start = run_.points.front(), &end = run_.points.back();
  bool startHeld = false, endHeld = false;
  base::parallelChunks(ctx_, 2, 1, [&](std::size_t which, std::size_t) {
    if (which == 0)
      startHeld = !ladder_.wasLifted(0) && !ladder_.liftable(start.at, start.next);
    else
      endHeld = !ladder_.wasLifted(last) && !ladder_.liftable(end.at, end.next + 1);
  });
  if (startHeld)
    ladder_.blockUnliftable(0, first_, ctx_);
  if (endHeld)
    ladder_.blockUnliftable(last, first_ + count_, ctx_);
  return !startHeld && !endHeld;
}

bool Stretch::settle(std::size_t failed) {
  if (failed < first_ + 2)
    return false;
  count_ = failed - first_;
  ladder_.setRungs(count_, ctx_);
  return true;
}

void Stretch::lookCloser(const LadderPath& ladderPath, const std::vector<Failed>& failed,
                         bool judgeAll) {
  std::vector<std::size_t> about;
  if (judgeAll) {
    for (std::size_t r = 0; r < ladder_.size(); ++r)
      about.push_back(r);
  } else {
    for (const Failed& f : failed) {
      const std::size_t r = ladder_.rungAt(f.waypoint);
      if (f.passes)
        continue; // Occurs between rungs, not at one
      for (std::size_t k = r < 2 ? 0 : r - 2; k < std::min(r + 2, ladder_.size()); ++k)
        about.push_back(k);
    }
  }
  ladder_.judge(about, ctx_);
  std::vector<std::size_t> between;
  for (const auto& [w, passes] : failed) {
    const std::size_t r = ladder_.rungAt(w);
    if (passes)
      ladder_.keepJacobianSigns(r);
    LadderNode& here = ladder_.node(r, ladderPath.node[r]);
    if (r > 0) {
      const LadderNode& last = ladder_.node(r - 1, ladderPath.node[r - 1]);
      if (last.blocked || last.side * here.side < 0)
        continue;
    }
    if (here.blocked)
      continue;
    if (r > 0 && ladder_.waypointOf(r) - ladder_.waypointOf(r - 1) > 1)
      between.push_back(w);
    else
      here.blocked = true; // Free of collisions itself, but not the motion to it
  }
  for (const std::size_t w : between)
    ladder_.refine(ladder_.rungAt(w), ctx_);
}

std::size_t Stretch::plan(std::vector<Run>& runs, std::vector<Refused>& refused) {
  if (count_ == 0) {
    refused.push_back({first_, Refusal::Unreachable, {}});
    return 1;
  }
  ladder_.setRungs(count_, ctx_);
  int seeks = 0;
  for (int tries = 0;; ++tries) {
    ctx_.checkpoint();
    const base::Stopwatch watch;
    const LadderPath ladderPath = ladder_.bestPath(ctx_);
    times_.graph += watch.seconds();

    if (ladderPath.reached < ladder_.size()) {
      if (goFurther(ladderPath))
        continue;
      return refuseStart(ladderPath, refused);
    }
    if (count_ < 2) {
      refused.push_back(ladder_.refusalOf(0));
      return 1;
    }
    // Before following the path, which costs more than measuring the clearance at its rungs.
    if (seeks < kSeeks && ladder_.seekClearance(ladderPath, ctx_)) {
      ++seeks;
      continue;
    }
    const std::vector<Failed> failed = follow(ladderPath);
    if (failed.empty()) {
      if (wantsLift_ && !endsLift())
        continue;
      smooth();
      run_.ladder = jointsOf(unsmoothed_);
      runs.push_back(std::move(run_));
      return count_;
    }
    if (tries < kTries) {
      lookCloser(ladderPath, failed, tries - seeks >= kTriesBeforeJudgingAll);
      continue;
    }
    if (!settle(failed.front().waypoint)) {
      refused.push_back({first_, Refusal::NoConnection, {}});
      return 1;
    }
    tries = 0;
  }
}

} // namespace

void PathPlanner::joinLast(std::vector<Run>& runs) const {
  const Run& after = runs.back();
  Run& before = runs[runs.size() - 2];
  if (before.points.back().waypoint != after.points.front().waypoint)
    return;
  BlendedRun blended = blendBranches(scene_, before, after, scene_.options.leanRad);
  if (!blended.run)
    return;
  before = std::move(*blended.run);
  runs.pop_back();
}

void PathPlanner::plan(std::size_t path, std::size_t first, std::size_t count,
                       const RobotState& from, const base::RunContext& ctx, std::vector<Run>& runs,
                       std::vector<Refused>& refused) {
  RobotState last = from;
  const TimingLimits limits =
      timingLimits(scene_.cell, tooling_.of(scene_.plan.paths[path]).process);
  const bool learns =
      scene_.options.learnedCollisions && scene_.options.smoothing == SmoothingMethod::WholePath;
  const RunSmoothing smoothing{scene_, scene_.twists, limits,
                               learns ? learned_.of(path, ctx.quiet()) : nullptr};
  const std::size_t firstRun = runs.size();
  std::size_t done = 0;
  while (done < count) {
    ctx.checkpoint();
    const std::size_t runsBefore = runs.size(), refusedBefore = refused.size();
    const std::size_t step =
        Stretch(smoothing, path, first + done, count - done, last, ctx, times_).plan(runs, refused);
    // The end of the previous run is printed, whether or not the next run continues from there.
    if (refused.size() > refusedBefore && !runs.empty() &&
        refused[refusedBefore].waypoint == runs.back().points.back().waypoint)
      refused.erase(refused.begin() + static_cast<std::ptrdiff_t>(refusedBefore));
    done += step;
    if (runs.size() > runsBefore) {
      if (scene_.options.blendsBranches && runsBefore > firstRun)
        joinLast(runs);
      last = runs.back().points.back().at;
      // The next run begins where this one ended, so that nothing stays unprinted between them.
      if (done < count)
        --done;
    }
  }
}

} // namespace voluta::motion
