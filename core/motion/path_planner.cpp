#include "motion/path_planner.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "motion/even_turns.h"
#include "motion/joint_costs.h"
#include "motion/nozzle_frame.h"
#include "motion/rod_turn.h"
#include "process/bead_model.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kTurn = 2.0 * base::kPi;
constexpr double kRungStep = 0.9; // rad, joint step between rungs that are some steps apart
constexpr int kTries = 40;        // of blocking what failed and searching again
constexpr int kTriesBeforeJudgingAll = 6;
constexpr double kSmoothing = 200.0; // waves under about 24 waypoints go
constexpr std::size_t kCheckChunk = 16;

} // namespace

void PathPlanner::plan(std::size_t path, std::size_t first, std::size_t count,
                       const RobotState& from, const base::RunContext& ctx, std::vector<Run>& runs,
                       std::vector<Refused>& refused) {
  RobotState last = from;
  std::size_t done = 0;
  while (done < count) {
    ctx.checkpoint();
    const std::size_t runsBefore = runs.size(), refusedBefore = refused.size();
    const std::size_t step = planPrefix(path, first + done, count - done, last, ctx, runs, refused);
    // Where the run before ended is printed, whether or not it goes on from there.
    if (refused.size() > refusedBefore && !runs.empty() &&
        refused[refusedBefore].waypoint == runs.back().points.back().waypoint)
      refused.erase(refused.begin() + static_cast<std::ptrdiff_t>(refusedBefore));
    done += step;
    if (runs.size() > runsBefore) {
      last = runs.back().points.back().at;
      // The next run begins where this one ended, so that nothing stays unprinted between them.
      if (done < count)
        --done;
    }
  }
}

// Turns about the nozzle and of the rod at every waypoint from the ladder's: linear in the way
// between rungs.
PathPlanner::Course PathPlanner::courseOf(const Ladder& ladder, const LadderWay& way) const {
  const plan::ToolPlan& plan = scene_.plan;
  const int samples = scene_.options.samples;
  Course course;
  double turn = 0.0, rod = 0.0;
  int last = 0;
  for (std::size_t r = 0; r < way.reached; ++r) {
    const LadderNode& node = ladder.rungs[r][static_cast<std::size_t>(way.node[r])];
    const int sample = node.sample;
    int change = r == 0 ? sample : (sample - last + samples) % samples;
    if (change > samples / 2)
      change -= samples;
    const double next = turn + kTurn * change / samples, nextRod = kRodStep * node.rod;
    if (r == 0) {
      course.turn.push_back(next);
      course.rod.push_back(nextRod);
    } else {
      const std::size_t b = ladder.places[r - 1].waypoint, e = ladder.places[r].waypoint;
      double length = 0.0;
      for (std::size_t i = b + 1; i <= e; ++i)
        length += (plan.position[i] - plan.position[i - 1]).norm();
      double travelled = 0.0;
      for (std::size_t i = b + 1; i <= e; ++i) {
        travelled += (plan.position[i] - plan.position[i - 1]).norm();
        const double t = length > 0.0 ? travelled / length
                                      : static_cast<double>(i - b) / static_cast<double>(e - b);
        course.turn.push_back(turn + t * (next - turn));
        course.rod.push_back(rod + t * (nextRod - rod));
      }
    }
    turn = next;
    rod = nextRod;
    last = sample;
  }
  return course;
}

// The points of waypoints [first, first + course.turn.size()), divided where the nozzle would bend
// off its way. False: at waypoint failedAt the joints cannot follow.
bool PathPlanner::fill(std::size_t first, const Course& course, const JointVector& start,
                       std::vector<RunPoint>& points, std::size_t& failedAt) const {
  const plan::ToolPlan& plan = scene_.plan;
  points.clear();
  std::vector<JointVector> scratch;
  const auto toolAt = [&](std::size_t i) {
    return turned(tools_[i - toolsFirst_], course.turn[i - first]);
  };
  const auto rodTo = [&](std::size_t i) { return rodAt(i) + course.rod[i - first]; };
  JointVector q;
  // The first solution may differ from the ladder's where turns were evened out.
  if (!solveNear(scene_.cell, plan.position[first], toolAt(first), start, kRungStep, scratch, q)) {
    failedAt = first;
    return false;
  }
  points.push_back(
      {{plan.position[first], toolAt(first), q, rodTo(first)}, first, first, 0.0, 0.0});
  for (std::size_t i = first + 1; i < first + course.turn.size(); ++i) {
    const Quaterniond from = toolAt(i - 1), to = toolAt(i);
    const Vector3d a = plan.position[i - 1], b = plan.position[i];
    const int n = scene_.divisions(a, b, angleBetween(from, to));
    const double volume = 0.5 *
                          (process::beadArea(plan.widthMm[i - 1], plan.heightMm[i - 1]) +
                           process::beadArea(plan.widthMm[i], plan.heightMm[i])) *
                          (b - a).norm() / n;
    for (int k = 1; k <= n; ++k) {
      const double t = static_cast<double>(k) / n;
      const Vector3d tip = k == n ? b : Vector3d(a + t * (b - a));
      const Quaterniond tool = k == n ? to : from.slerp(t, to);
      const double rod = k == n ? rodTo(i) : rodTo(i - 1) + t * (rodTo(i) - rodTo(i - 1));
      const JointVector last = withRod(scene_.cell, q, rod);
      if (!solveNear(scene_.cell, tip, tool, last, scene_.options.maxStepRad, scratch, q)) {
        failedAt = i;
        return false;
      }
      points.push_back({{tip, tool, q, rod},
                        k == n ? i : plan::kNoWaypoint,
                        i,
                        volume,
                        static_cast<double>(plan.speedMmPerS[i])});
    }
  }
  return true;
}

std::vector<std::size_t> PathPlanner::failures(const std::vector<RunPoint>& points,
                                               const base::RunContext& ctx) const {
  std::vector<char> bad(points.size(), 0);
  base::parallelChunks(ctx, points.size(), kCheckChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e; ++p)
      bad[p] = contactAt(points[p].at.q, points[p].next).has_value();
  });
  std::vector<std::size_t> waypoints;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (bad[p] && (waypoints.empty() || waypoints.back() != points[p].next))
      waypoints.push_back(points[p].next);
  return waypoints;
}

// Of two ways to begin, by whole turns: near where the arm is, which may wind it up against its
// limits, and near home. The one that gets further, then the cheaper one.
LadderWay PathPlanner::bestWay(Ladder& ladder, const RobotState& from) const {
  const auto search = [&] {
    std::vector<double> startCosts;
    for (const LadderNode& node : ladder.rungs.front())
      startCosts.push_back(startCost(armOf(scene_.cell, from.q), armOf(scene_.cell, node.q)));
    return shortestWay(ladder.rungs, startCosts, scene_.cell.robot().limits, ladder.options);
  };
  const auto beginNear = [&](const JointVector& near) {
    bool changed = false;
    for (LadderNode& node : ladder.rungs.front())
      for (Eigen::Index j = 0; j < scene_.cell.armDof(); ++j) {
        const double turns = std::round((near[j] - node.q[j]) / kTurn);
        const auto& limit = scene_.cell.limits()[static_cast<std::size_t>(j)];
        const double q = node.q[j] + kTurn * turns;
        if (turns != 0.0 && q >= limit.min && q <= limit.max) {
          node.q[j] = q;
          changed = true;
        }
      }
    return changed;
  };
  beginNear(from.q);
  LadderWay near = search();
  const JointVector first = near.reached > 0 ? near.q.front() : from.q;
  const bool changed = beginNear(scene_.cell.home());
  if (!changed || (near.reached == ladder.rungs.size() &&
                   first == ladder.rungs.front()[static_cast<std::size_t>(near.node.front())].q))
    return near;
  LadderWay unwound = search();
  if (unwound.reached > near.reached ||
      (unwound.reached == near.reached && unwound.cost < near.cost))
    return unwound;
  return near;
}

std::size_t PathPlanner::planPrefix(std::size_t path, std::size_t first, std::size_t count,
                                    const RobotState& from, const base::RunContext& ctx,
                                    std::vector<Run>& runs, std::vector<Refused>& refused) {
  count = carryTools(first, count, from);
  if (count == 0) {
    refused.push_back({first, Refusal::Unreachable, {}});
    return 1;
  }
  Ladder ladder;
  ladder.options.samples = scene_.options.samples;
  ladder.options.window = std::max(1, scene_.options.samples / 12);
  const auto setPlaces = [&](const std::vector<std::size_t>& waypoints) {
    std::vector<Place> places;
    std::vector<Rung> rungs;
    std::vector<std::size_t> fresh;
    std::size_t old = 0;
    for (const std::size_t w : waypoints) {
      while (old < ladder.places.size() && ladder.places[old].waypoint < w)
        ++old;
      if (old < ladder.places.size() && ladder.places[old].waypoint == w) {
        places.push_back(std::move(ladder.places[old]));
        rungs.push_back(std::move(ladder.rungs[old]));
        ++old;
      } else {
        fresh.push_back(places.size());
        places.push_back({w, false, false, false, {}, {}});
        rungs.emplace_back();
      }
    }
    ladder.places = std::move(places);
    ladder.rungs = std::move(rungs);
    ladder.options.maxStepRad.assign(ladder.places.size(), kRungStep);
    for (std::size_t r = 1; r < ladder.places.size(); ++r)
      ladder.options.maxStepRad[r] =
          std::min(kRungStep,
                   scene_.options.maxStepRad * static_cast<double>(ladder.places[r].waypoint -
                                                                   ladder.places[r - 1].waypoint));
    addNodes(ladder, fresh, from, ctx);
    return fresh;
  };
  // Makes every waypoint between rungs r - 1 and r a rung. False: they were neighbours already.
  const auto refine = [&](std::size_t r) {
    const std::size_t b = ladder.places[r - 1].waypoint, e = ladder.places[r].waypoint;
    if (e - b <= 1)
      return false;
    std::vector<std::size_t> waypoints;
    for (const Place& p : ladder.places) {
      if (p.waypoint == e)
        for (std::size_t i = b + 1; i < e; ++i)
          waypoints.push_back(i);
      waypoints.push_back(p.waypoint);
    }
    judge(ladder, setPlaces(waypoints), ctx);
    return true;
  };
  const auto refuse = [&](const Place& place, const Rung& rung) {
    refused.push_back(refusal(place, rung));
  };
  setPlaces(rungWaypoints(first, count));

  Run run;
  run.path = path;
  bool wantsLift = true; // from both ends
  const auto close = [&](const LadderWay& way) {
    // Nothing further is joined: what is, is printed, and the rest begins anew.
    const std::size_t last = ladder.places[way.reached - 1].waypoint;
    std::vector<std::size_t> waypoints;
    for (const Place& p : ladder.places)
      if (p.waypoint <= last)
        waypoints.push_back(p.waypoint);
    setPlaces(waypoints);
    count = last - first + 1;
  };

  for (int tries = 0;; ++tries) {
    ctx.checkpoint();
    base::Stopwatch watch;
    const LadderWay way = bestWay(ladder, from);
    times_.graph += watch.seconds();

    if (way.reached < ladder.places.size() && widen(ladder, way.reached, from, ctx))
      continue;
    if (way.reached < ladder.places.size() && wantsLift) {
      bool relaxed = false;
      for (std::size_t r = 0; r < ladder.places.size(); ++r) {
        for (const std::size_t n : ladder.places[r].unliftable)
          ladder.rungs[r][n].blocked = false;
        relaxed = relaxed || !ladder.places[r].unliftable.empty();
        ladder.places[r].unliftable.clear();
      }
      // Better a run that is hard to leave than none.
      if (relaxed) {
        wantsLift = false;
        continue;
      }
    }
    if (way.reached == 0) {
      if (!rod_.empty())
        return refuseBlocked(ladder, from, ctx, refused);
      judge(ladder, {0}, ctx); // for the reason
      refuse(ladder.places[0], ladder.rungs[0]);
      return 1;
    }
    if (way.reached < ladder.places.size()) {
      const std::size_t r = way.reached;
      if (refine(r))
        continue;
      if (r == 1) {
        refuse(ladder.places[0], {LadderNode{}});
        return 1;
      }
      close(way);
      continue;
    }
    if (count < 2) {
      refuse(ladder.places[0], {LadderNode{}});
      return 1;
    }

    Course course = courseOf(ladder, way);
    std::vector<std::size_t> failed;
    std::size_t failedAt = 0;
    watch = base::Stopwatch();
    const bool followed = fill(first, course, way.q.front(), run.ladder, failedAt);
    bool good = false;
    // On a rod it often need not turn at all.
    const bool uneven =
        rod_.empty() || std::any_of(course.turn.begin(), course.turn.end(),
                                    [&](double t) { return t != course.turn.front(); });
    if (uneven)
      course.turn = evened(course.turn, kSmoothing);
    if (followed && uneven && scene_.options.smooth &&
        fill(first, course, way.q.front(), run.points, failedAt)) {
      times_.ik += watch.seconds();
      watch = base::Stopwatch();
      good = failures(run.points, ctx).empty();
      times_.collision += watch.seconds();
    } else {
      times_.ik += watch.seconds();
    }
    if (followed && !good) {
      watch = base::Stopwatch();
      run.points = run.ladder;
      failed = failures(run.points, ctx);
      times_.collision += watch.seconds();
      good = failed.empty();
    }
    if (good && wantsLift) {
      const auto endRung = ladder.places.size() - 1;
      const bool startHeld = !ladder.places.front().lifted &&
                             !liftable(run.points.front().at, run.points.front().next);
      const bool endHeld = !ladder.places[endRung].lifted &&
                           !liftable(run.points.back().at, run.points.back().next + 1);
      if (startHeld)
        blockUnliftable(ladder, 0, first, ctx);
      if (endHeld)
        blockUnliftable(ladder, endRung, first + count, ctx);
      if (startHeld || endHeld)
        continue;
    }
    if (good) {
      runs.push_back(std::move(run));
      return count;
    }
    if (!followed)
      failed = {failedAt};
    if (tries >= kTries) {
      // Settle for what comes before the first failure.
      const std::size_t end = failed.front();
      if (end < first + 2) {
        refuse({first, true, true, true, {}, {}}, {LadderNode{}});
        return 1;
      }
      count = end - first;
      setPlaces(rungWaypoints(first, count));
      tries = 0;
      continue;
    }

    // Judge the rungs about each failure; where the way's own nodes stay clear, look closer.
    std::vector<std::size_t> about;
    if (tries >= kTriesBeforeJudgingAll) {
      for (std::size_t r = 0; r < ladder.places.size(); ++r)
        about.push_back(r);
    } else {
      for (const std::size_t w : failed) {
        const auto at = std::lower_bound(
            ladder.places.begin(), ladder.places.end(), w,
            [](const Place& p, std::size_t waypoint) { return p.waypoint < waypoint; });
        const auto r = static_cast<std::size_t>(at - ladder.places.begin());
        for (std::size_t k = r < 2 ? 0 : r - 2; k < std::min(r + 2, ladder.places.size()); ++k)
          about.push_back(k);
      }
    }
    judge(ladder, about, ctx);
    std::vector<std::size_t> between;
    for (const std::size_t w : failed) {
      const auto at = std::lower_bound(
          ladder.places.begin(), ladder.places.end(), w,
          [](const Place& p, std::size_t waypoint) { return p.waypoint < waypoint; });
      const auto r = static_cast<std::size_t>(at - ladder.places.begin());
      LadderNode& here = ladder.rungs[r][static_cast<std::size_t>(way.node[r])];
      const bool blockedHere = here.blocked;
      const bool blockedBefore =
          r > 0 && ladder.rungs[r - 1][static_cast<std::size_t>(way.node[r - 1])].blocked;
      if (blockedHere || blockedBefore)
        continue;
      if (r > 0 && ladder.places[r].waypoint - ladder.places[r - 1].waypoint > 1)
        between.push_back(w);
      else
        here.blocked = true; // clear itself, but not on the way to it
    }
    for (const std::size_t w : between) {
      const auto at = std::lower_bound(
          ladder.places.begin(), ladder.places.end(), w,
          [](const Place& p, std::size_t waypoint) { return p.waypoint < waypoint; });
      refine(static_cast<std::size_t>(at - ladder.places.begin()));
    }
  }
}

} // namespace voluta::motion
