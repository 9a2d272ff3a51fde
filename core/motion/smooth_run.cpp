#include "motion/smooth_run.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "motion/nozzle_frame.h"
#include "motion/smooth_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::motion {

namespace {

constexpr std::size_t kCheckChunk = 16;
// How hard points are held about one that meets something, and together where steps turn too far:
// each time more.
constexpr int kPulls = 6;
constexpr double kFirstStay = 1e-5, kMoreStay = 100.0, kFirstTogether = 1e-3, kMoreTogether = 30.0;
constexpr std::size_t kMeetingWindow = 24, kFarWindow = 3; // points to both sides
// Of the deviation: the run's own steps end just inside. In the last rounds a little more will do.
constexpr double kBendSlack = 1.05, kLastBendSlack = 1.2;
constexpr int kStrictPulls = 3;
constexpr TurnSmoothing kAfterPull{3, 1e-2, 0.3};

std::vector<RunPoint> turnedBy(const std::vector<RunPoint>& points,
                               const std::vector<TurnedPoint>& at) {
  std::vector<RunPoint> turnedPoints = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (at[i].turn != 0.0) {
      turnedPoints[i].at.tool = turned(points[i].at.tool, at[i].turn);
      turnedPoints[i].at.q = at[i].q;
    }
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
  const auto tool = [&](std::size_t i) { return turned(points[i].at.tool, at[i].turn); };
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

} // namespace

SmoothedRun smoothRun(const RunSmoothing& by, const std::vector<RunPoint>& points,
                      const Meets& meets, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  const std::size_t n = points.size();
  SmoothedRun result{points};
  const auto meeting = [&](const std::vector<TurnedPoint>& at) {
    const base::Stopwatch checking;
    std::vector<char> found(n, 0);
    base::parallelChunks(ctx, n, kCheckChunk, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i)
        found[i] = meets(at[i].q, points[i].next);
    });
    result.checkS += checking.seconds();
    return found;
  };
  const auto any = [](const std::vector<char>& marks) {
    return std::find(marks.begin(), marks.end(), 1) != marks.end();
  };
  const TurnSmoother smoother(by.scene.cell, by.twists, points, nozzleTimes(by, points));
  const std::vector<TurnedPoint> start = smoother.start(ctx);
  const std::vector<TurnHold> free(n);
  std::vector<TurnedPoint> at = start;
  std::vector<TurnHold> holds = free;
  // The ladder laid ends where the next path's start is near, and whence the nozzle can be lifted.
  holds.front().stay = holds.back().stay = kHeld;
  smoother.smooth(at, holds, {}, ctx);
  for (int k = 0; k <= kPulls; ++k) {
    if (k > 0)
      smoother.smooth(at, holds, kAfterPull, ctx);
    const std::vector<char> met = meeting(at),
                            far = longSteps(by.scene, points, at,
                                            k < kStrictPulls ? kBendSlack : kLastBendSlack);
    if (!any(met) && !any(far)) {
      if (smoother.cost(at, free) <= smoother.cost(start, free))
        result.points = turnedBy(points, at);
      break;
    }
    std::vector<TurnHold> more = holds;
    for (std::size_t i = 0; i < n; ++i) {
      if (met[i])
        about(i, kMeetingWindow, n, [&](std::size_t m) {
          more[m].stay = std::max(kFirstStay, kMoreStay * holds[m].stay);
        });
      if (far[i])
        about(i, kFarWindow, n, [&](std::size_t m) {
          more[m].together = std::max(kFirstTogether, kMoreTogether * holds[m].together);
        });
    }
    holds = std::move(more);
  }
  result.smoothS = watch.seconds() - result.checkS;
  return result;
}

} // namespace voluta::motion
