#include "motion/smoothing/smooth_run.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/ladder/divided_step.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/smooth_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace voluta::motion {

using Eigen::Quaterniond;

namespace {

constexpr std::size_t kCheckChunk = 16;
// How hard points are held about one that meets something, and together where steps turn too far:
// each time more.
constexpr int kPulls = 6;
constexpr int kDivisions = 3; // of steps that turn far, where directions lean
constexpr double kFirstStay = 1e-5, kMoreStay = 100.0, kFirstTogether = 1e-3, kMoreTogether = 30.0;
constexpr std::size_t kMeetingWindow = 24, kHeadWindow = 12, kFarWindow = 3; // points to both sides
// As far as directions were chosen to be from what is printed already.
constexpr double kHeadMm = 0.05;
constexpr double kSameDirection = 1e-6; // rad
// Of the deviation: the run's own steps end just inside. In the last rounds a little more will do.
constexpr double kBendSlack = 1.05, kLastBendSlack = 1.2;
constexpr int kStrictPulls = 3;
constexpr std::size_t kMostFreeAxes = 2;
constexpr TurnSmoothing kAfterPull{3, 1e-2, 0.3};
constexpr TurnSmoothing kAtLast{12, 1e-3, 0.3}; // where nothing is divided any more
// Of the ends: they turn by degrees where that takes a kick away, and stay near other paths.
constexpr double kEndStay = 1e-3;

RunPoint turnedBy(RunPoint point, const TurnedPoint& at) {
  if (at.turn != 0.0 || !at.lean.isZero(0.0) || !at.aside.isZero(0.0)) {
    point.at.tool = at.tool(point.at.tool);
    point.at.q = at.q;
    if (at.aside.size() > 0)
      point.at.axes += at.aside;
  }
  return point;
}

std::vector<RunPoint> turnedBy(const std::vector<RunPoint>& points,
                               const std::vector<TurnedPoint>& at) {
  std::vector<RunPoint> turnedPoints;
  for (std::size_t i = 0; i < points.size(); ++i)
    turnedPoints.push_back(turnedBy(points[i], at[i]));
  return turnedPoints;
}

// The times that the ways would take if joints had no limits: those of the nozzle alone, as the
// process wants it. Turns do not change them.
std::vector<double> nozzleTimes(const RunSmoothing& by, const std::vector<RunPoint>& points) {
  TimingLimits limits = by.limits;
  for (robot::JointLimits& limit : limits.joints)
    limit.velocity = limit.acceleration = std::numeric_limits<double>::infinity();
  std::vector<TimedPoint> timed;
  for (const RunPoint& p : points)
    timed.push_back({points.front().at.q, p.at.tip, p.speedMmPerS, false, false, {}});
  return timesOf(timed, limits);
}

// Which steps turn further than the run's own and so far that the nozzle would bend off its way, or
// that a joint would jump: a mark for their later end.
std::vector<char> longSteps(const MotionScene& scene, const std::vector<RunPoint>& points,
                            const std::vector<TurnedPoint>& at, double slack) {
  std::vector<char> marks(points.size(), 0);
  const auto tool = [&](std::size_t i) { return at[i].tool(points[i].at.tool); };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const RobotState &from = points[i - 1].at, &to = points[i].at;
    const double angle = angleBetween(tool(i - 1), tool(i));
    const bool bends = scene.bend(from.tip, to.tip, angle) > slack * scene.options.deviationMm &&
                       angle > angleBetween(from.tool, to.tool);
    const double step = robot::largestTurn(at[i].q - at[i - 1].q, scene.cell.robot().limits);
    marks[i] = bends || step > scene.options.maxStepRad;
  }
  return marks;
}

// Points from `window` before i to so many after it, as far as there are.
template <typename Body>
void about(std::size_t i, std::size_t window, std::size_t count, const Body& body) {
  for (std::size_t k = i < window ? 0 : i - window; k < std::min(count, i + window + 1); ++k)
    body(k);
}

// How a run goes on being smoothed where it must not be as it came out.
struct Marks {
  std::vector<char> met, head, far; // a point: what meets, of that the head alone; longSteps()
  bool any() const {
    const auto marked = [](const std::vector<char>& m) {
      return std::find(m.begin(), m.end(), 1) != m.end();
    };
    return marked(met) || marked(head) || marked(far);
  }
};

std::vector<TurnHold> heldWhere(const Marks& marks, const std::vector<TurnHold>& holds) {
  const std::size_t n = holds.size();
  const auto more = [](double hold, double first, double by) { return std::max(first, by * hold); };
  std::vector<TurnHold> held = holds;
  for (std::size_t i = 0; i < n; ++i) {
    if (marks.met[i])
      about(i, kMeetingWindow, n, [&](std::size_t m) {
        held[m].stay = more(holds[m].stay, kFirstStay, kMoreStay);
        held[m].upright = more(holds[m].upright, kFirstStay, kMoreStay);
      });
    if (marks.head[i])
      about(i, kHeadWindow, n, [&](std::size_t m) {
        held[m].upright = more(holds[m].upright, kFirstStay, kMoreStay);
      });
    if (marks.far[i])
      about(i, kFarWindow, n, [&](std::size_t m) {
        held[m].together = more(holds[m].together, kFirstTogether, kMoreTogether);
      });
  }
  return held;
}

// One direction all along makes no jerk, and stays: flat layers are printed upright.
bool directionsChange(const std::vector<RunPoint>& points) {
  const Eigen::Vector3d first = points.front().at.direction();
  return std::any_of(points.begin(), points.end(), [&](const RunPoint& p) {
    return (p.at.direction() - first).norm() > kSameDirection;
  });
}

// Axes that stand still along a run make no jerk, and stay. One that goes in steps does too: what
// its motor makes of a smooth way is not on it.
bool axesMove(const robot::Cell& cell, const std::vector<RunPoint>& points) {
  const auto& axes = cell.externalAxes();
  if (axes.empty() || axes.size() > kMostFreeAxes || cell.rod() ||
      std::any_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.step > 0.0; }))
    return false;
  return std::any_of(points.begin(), points.end(),
                     [&](const RunPoint& p) { return p.at.axes != points.front().at.axes; });
}

// Does the head, leaning so, keep from plate and part what directions keep where they can?
bool headMeets(const MotionScene& scene, const RunPoint& point, const Quaterniond& tool) {
  const Eigen::Isometry3d work_T_tool = toolPose(point.at.tip, tool);
  return scene.collision.headTouchesPart(work_T_tool, scene.part, point.next, kHeadMm) ||
         scene.collision.headTouchesPlatform(work_T_tool, kHeadMm);
}

// The run with the marked steps divided as finely as those turn that `at` has in their place. Where
// joints cannot follow, as it was.
std::vector<RunPoint> dividedWhere(const MotionScene& scene, const std::vector<char>& marks,
                                   const std::vector<RunPoint>& points,
                                   const std::vector<TurnedPoint>& at) {
  std::vector<RunPoint> divided{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const RobotState &from = points[i - 1].at, &to = points[i].at;
    if (!marks[i]) {
      divided.push_back(points[i]);
      continue;
    }
    const double angle = angleBetween(at[i - 1].tool(from.tool), at[i].tool(to.tool));
    if (!appendDivided(scene, points[i], std::max(2, scene.divisions(from.tip, to.tip, angle)),
                       divided))
      return points;
    divided.back().at.q = to.q;
  }
  return divided;
}

// The run smoothed with directions that lean up to leanRad, and as it was before with what had to
// be divided; none where it does not come clear of everything or is no smoother.
std::optional<SmoothedRun> smoothedWithin(double leanRad, double axesRad, const RunSmoothing& by,
                                          std::vector<RunPoint> points, const Meets& meets,
                                          const Lifts& lifts, double& checkS,
                                          const base::RunContext& ctx) {
  // Whether something meets, and of what leans whether the head does.
  const auto look = [&](const std::vector<TurnedPoint>& at, bool startOnly, Marks& marks) {
    const base::Stopwatch checking;
    marks.met.assign(at.size(), 0);
    marks.head.assign(at.size(), 0);
    base::parallelChunks(ctx, at.size(), kCheckChunk, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i) {
        marks.met[i] = !startOnly && meets(at[i].q, points[i].next);
        if (startOnly ? leanRad > 0.0 : !at[i].lean.isZero(0.0))
          marks.head[i] = headMeets(by.scene, points[i], at[i].tool(points[i].at.tool));
      }
    });
    checkS += checking.seconds();
  };
  // Where external axes move the ends stand as scheduled, unless they may lean.
  bool firstIsFree = leanRad > 0.0 || axesRad == 0.0, lastIsFree = firstIsFree;
  const double endStay = axesRad == 0.0 ? kEndStay : kHeld;
  for (int division = 0;;) {
    const std::size_t n = points.size();
    const TurnSmoother smoother(by.scene.cell, by.twists, points, nozzleTimes(by, points), leanRad,
                                axesRad);
    const std::vector<TurnedPoint> start = smoother.start(ctx);
    const std::vector<TurnHold> free(n);
    std::vector<TurnedPoint> at = start;
    std::vector<TurnHold> holds = free;
    Marks marks;
    look(start, true, marks);
    for (std::size_t i = 0; i < n; ++i)
      if (marks.head[i])
        holds[i].upright = kHeld;
    // The ladder laid ends where the next path's start is near, and whence the nozzle can be
    // lifted. They turn a little and lean where that stays so.
    const auto holdEnd = [&](TurnHold& hold, bool isFree) {
      hold.stay = isFree ? endStay : kHeld;
      if (!isFree)
        hold.upright = kHeld;
    };
    holdEnd(holds.front(), firstIsFree);
    holdEnd(holds.back(), lastIsFree);
    smoother.smooth(at, holds, {}, ctx);
    const auto firstLifts = [&] {
      return !firstIsFree || lifts(turnedBy(points.front(), at.front()).at, false);
    };
    const auto lastLifts = [&] {
      return !lastIsFree || lifts(turnedBy(points.back(), at.back()).at, true);
    };
    const auto bothLift = [&] {
      const bool firstStays = !firstLifts(), lastStays = !lastLifts();
      firstIsFree = firstIsFree && !firstStays;
      lastIsFree = lastIsFree && !lastStays;
      return !firstStays && !lastStays;
    };
    if (!bothLift())
      continue;
    if (leanRad > 0.0 && division < kDivisions) {
      const std::vector<char> far = longSteps(by.scene, points, at, kBendSlack);
      std::vector<RunPoint> divided = dividedWhere(by.scene, far, points, at);
      if (divided.size() > n) {
        points = std::move(divided);
        ++division;
        continue;
      }
    }
    smoother.smooth(at, holds, kAtLast, ctx);
    if (!bothLift())
      continue;
    for (int k = 0; k <= kPulls; ++k) {
      if (k > 0)
        smoother.smooth(at, holds, kAfterPull, ctx);
      look(at, false, marks);
      marks.far = longSteps(by.scene, points, at, k < kStrictPulls ? kBendSlack : kLastBendSlack);
      if (!marks.any()) {
        if ((k > 0 && (!firstLifts() || !lastLifts())) ||
            smoother.cost(at, free) > smoother.cost(start, free))
          return std::nullopt;
        return SmoothedRun{turnedBy(points, at), std::move(points)};
      }
      holds = heldWhere(marks, holds);
    }
    return std::nullopt;
  }
}

} // namespace

SmoothedRun smoothRun(const RunSmoothing& by, const std::vector<RunPoint>& points,
                      const Meets& meets, const Lifts& lifts, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  const robot::Cell& cell = by.scene.cell;
  const bool leans = cell.tilts() && !cell.rod() && directionsChange(points);
  const double leanRad = leans ? by.scene.options.leanRad : 0.0;
  const double axesRad = axesMove(cell, points) ? by.scene.options.axesRad : 0.0;
  double checkS = 0.0;
  std::optional<SmoothedRun> smoothed;
  const auto tryWithin = [&](double lean, double axes) {
    if (!smoothed)
      smoothed = smoothedWithin(lean, axes, by, points, meets, lifts, checkS, ctx);
  };
  if (leanRad > 0.0)
    tryWithin(leanRad, axesRad);
  if (axesRad > 0.0)
    tryWithin(0.0, axesRad);
  tryWithin(0.0, 0.0);
  SmoothedRun result = smoothed ? std::move(*smoothed) : SmoothedRun{points, points};
  result.checkS = checkS;
  result.smoothS = watch.seconds() - checkS;
  return result;
}

} // namespace voluta::motion
