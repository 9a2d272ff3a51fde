#include "motion/smoothing/smooth_run.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "collision/cell_collision.h"
#include "motion/ladder/divided_step.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/smooth_turns.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace voluta::motion {

using Eigen::Quaterniond;

namespace {

constexpr std::size_t kCheckChunk = 16;
// Rounds of pulling points back towards their original pose around collisions, and towards each
// other where steps rotate too far; the weights increase each round.
constexpr int kPulls = 6;
constexpr int kDivisions = 3; // Divisions of steps that rotate too far, if directions lean
constexpr double kFirstStay = 1e-5, kMoreStay = 100.0, kFirstTogether = 1e-3, kMoreTogether = 30.0;
constexpr std::size_t kMeetingWindow = 24, kHeadWindow = 12, kFarWindow = 3; // Points on both sides
// The clearance to printed material with which directions were chosen.
constexpr double kHeadMm = 0.05;
constexpr double kSameDirection = 1e-6; // [rad]
// Allowed excess over the deviation, since the run's own steps end just below it. The last rounds
// allow a little more.
constexpr double kBendSlack = 1.05, kLastBendSlack = 1.2;
constexpr int kStrictPulls = 3;
constexpr std::size_t kMaxFreeAxes = 2;
constexpr RotationSmoothing kAfterPull{3, 1e-2, 0.3};
// For the final smoothing, when no more steps are divided
constexpr RotationSmoothing kAtLast{12, 1e-3, 0.3};
// Weight at the ends: they may rotate slightly where that removes a kick, and stay near other
// paths.
constexpr double kEndStay = 1e-3;

RunPoint turnedBy(RunPoint point, const TurnedPoint& at) {
  if (at.rotation != 0.0 || !at.lean.isZero(0.0) || !at.offset.isZero(0.0)) {
    point.at.tool = at.tool(point.at.tool);
    point.at.q = at.q;
    if (at.offset.size() > 0)
      point.at.axes += at.offset;
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

// Returns the times of the steps if joints had no limits: those of the nozzle alone, as the process
// requires. Rotations do not change them.
std::vector<double> nozzleTimes(const RunSmoothing& by, const std::vector<RunPoint>& points) {
  TimingLimits limits = by.limits;
  for (robot::JointLimits& limit : limits.joints)
    limit.velocity = limit.acceleration = std::numeric_limits<double>::infinity();
  std::vector<TimedPoint> timed;
  for (const RunPoint& p : points)
    timed.push_back({points.front().at.q, p.at.tip, p.speedMmPerS, false, false, {}});
  return timesOf(timed, limits);
}

// Marks the later end of each step that rotates further than the run's own step and so far that the
// nozzle would deviate from its path, or in which a joint would jump.
std::vector<char> longSteps(const MotionScene& scene, const std::vector<RunPoint>& points,
                            const std::vector<TurnedPoint>& at, double slack) {
  std::vector<char> marks(points.size(), 0);
  const auto tool = [&](std::size_t i) { return at[i].tool(points[i].at.tool); };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const RobotState &from = points[i - 1].at, &to = points[i].at;
    const double angle = angleBetween(tool(i - 1), tool(i));
    const bool bends = scene.bend(from.tip, to.tip, angle) > slack * scene.options.deviationMm &&
                       angle > angleBetween(from.tool, to.tool);
    const double step = robot::largestRotation(at[i].q - at[i - 1].q, scene.cell.robot().limits);
    marks[i] = bends || step > scene.options.maxStepRad;
  }
  return marks;
}

// Visits the points from `window` before i to `window` after it, within [0, count).
template <typename Body>
void about(std::size_t i, std::size_t window, std::size_t count, const Body& body) {
  for (std::size_t k = i < window ? 0 : i - window; k < std::min(count, i + window + 1); ++k)
    body(k);
}

// Points of a smoothed run that must be corrected.
struct Marks {
  std::vector<char> met, head, far; // Per point: collides, the head alone collides, longSteps()
  bool any() const {
    const auto marked = [](const std::vector<char>& m) {
      return std::find(m.begin(), m.end(), 1) != m.end();
    };
    return marked(met) || marked(head) || marked(far);
  }
};

std::vector<RotationHold> heldWhere(const Marks& marks, const std::vector<RotationHold>& holds) {
  const std::size_t n = holds.size();
  const auto more = [](double hold, double first, double by) { return std::max(first, by * hold); };
  std::vector<RotationHold> held = holds;
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

// A constant direction causes no jerk and is kept: flat layers are printed upright.
bool directionsChange(const std::vector<RunPoint>& points) {
  const Eigen::Vector3d first = points.front().at.direction();
  return std::any_of(points.begin(), points.end(), [&](const RunPoint& p) {
    return (p.at.direction() - first).norm() > kSameDirection;
  });
}

// Axes at rest along a run cause no jerk and are kept. So are axes with steps, because their motors
// would not follow a smooth path.
bool axesMove(const robot::Cell& cell, const std::vector<RunPoint>& points) {
  const auto& axes = cell.externalAxes();
  if (axes.empty() || axes.size() > kMaxFreeAxes || cell.rod() ||
      std::any_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.step > 0.0; }))
    return false;
  return std::any_of(points.begin(), points.end(),
                     [&](const RunPoint& p) { return p.at.axes != points.front().at.axes; });
}

// Returns whether the head, with this tilt, violates the clearance to plate and part that
// directions keep where possible.
bool headMeets(const MotionScene& scene, const RunPoint& point, const Quaterniond& tool) {
  const Eigen::Isometry3d work_T_tool = toolPose(point.at.tip, tool);
  return scene.collision.headTouchesPart(work_T_tool, scene.part, point.next, kHeadMm) ||
         scene.collision.headTouchesPlatform(work_T_tool, kHeadMm);
}

// Returns the run with the marked steps divided as finely as required by the rotations of `at`;
// unchanged if the joints cannot follow.
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

// Returns the run smoothed with directions that lean up to leanRad, and the original run with the
// same divisions. Returns nullopt if the result is not collision-free or not smoother.
std::optional<SmoothedRun> smoothedWithin(double leanRad, double axesRad, const RunSmoothing& by,
                                          std::vector<RunPoint> points, const Meets& meets,
                                          const Lifts& lifts, double& checkS,
                                          const base::RunContext& ctx) {
  // Marks the points that collide and, for leaning directions, those at which the head does.
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
  // If external axes move, the ends keep their scheduled pose unless directions may lean.
  bool firstIsFree = leanRad > 0.0 || axesRad == 0.0, lastIsFree = firstIsFree;
  const double endStay = axesRad == 0.0 ? kEndStay : kHeld;
  for (int division = 0;;) {
    const std::size_t n = points.size();
    RotationSmoother smoother(by.scene.cell, by.twists, points, nozzleTimes(by, points), leanRad,
                              axesRad);
    if (by.nearness)
      smoother.avoid(*by.nearness);
    const std::vector<TurnedPoint> start = smoother.start(ctx);
    const std::vector<RotationHold> free(n);
    std::vector<TurnedPoint> at = start;
    std::vector<RotationHold> holds = free;
    Marks marks;
    look(start, true, marks);
    for (std::size_t i = 0; i < n; ++i)
      if (marks.head[i])
        holds[i].upright = kHeld;
    // The ladder chose ends near the next path's start from which the nozzle can be lifted. They
    // may rotate and lean a little as long as lifting remains possible.
    const auto holdEnd = [&](RotationHold& hold, bool isFree) {
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
  // Directions determine the axes there, and rotating the nozzle moves nothing.
  if (robot::tiltsPart(cell))
    return {points, points};
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
