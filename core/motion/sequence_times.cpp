#include "motion/sequence_times.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "motion/jerk_limit.h"
#include "motion/shot_events.h"
#include "motion/timed_points.h"
#include "motion/timing.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using robot::JointVector;

namespace {

// A joint that moves by d from rest to rest within T has at least this share of d / T^3 as its
// greatest jerk, with any profile.
constexpr double kRestToRest = 32.0;
// Rounding of the times of a limited motion
constexpr double kSlack = 1.001;

// The piece of a transfer between two rests.
struct Between {
  std::vector<JointVector> q;
  std::vector<double> times; // from 0
};

Between between(const std::vector<TimedPoint>& points, const std::vector<double>& times,
                std::size_t first, std::size_t last) {
  Between piece;
  for (std::size_t i = first; i <= last; ++i) {
    piece.q.push_back(points[i].q);
    piece.times.push_back(times[i] - times[first]);
  }
  return piece;
}

// Returns the jerk of each joint from rest to rest, at least that of the profile with the smallest
// one: a transfer has too few points to measure it in between.
JerkMeasure jerkBetween(const Between& piece, const std::vector<robot::JointLimits>& limits) {
  JerkMeasure jerk = jerkOf(piece.q, piece.times, limits);
  const double seconds = piece.times.back();
  const JointVector step = (piece.q.back() - piece.q.front()).cwiseAbs();
  for (std::size_t j = 0; j < jerk.maxAbs.size() && seconds > 0.0; ++j)
    jerk.maxAbs[j] = std::max(jerk.maxAbs[j], kRestToRest * step[static_cast<Eigen::Index>(j)] /
                                                  (seconds * seconds * seconds));
  return jerk;
}

double maxAngularJerk(const JerkMeasure& jerk, const std::vector<robot::JointLimits>& limits) {
  double maximum = 0.0;
  for (std::size_t j = 0; j < jerk.maxAbs.size(); ++j)
    maximum = std::max(maximum, robot::asAngle(limits[j].kind, jerk.maxAbs[j]));
  return maximum;
}

// Slows a piece until its jerk keeps the limit.
void limitJerk(Between& piece, const std::vector<robot::JointLimits>& limits, double maxJerk) {
  if (piece.q.size() > 2)
    piece.times = timesWithinJerk(piece.q, piece.times, limits, maxJerk);
  const double share = maxAngularJerk(jerkBetween(piece, limits), limits) / maxJerk;
  if (share > kSlack)
    for (double& t : piece.times)
      t *= std::min(std::cbrt(share), kMaxSlowdown);
}

class SequenceTimer {
public:
  SequenceTimer(const Sequence& sequence, const MotionScene& scene, const process::Tooling& tooling,
                const RobotState& home)
      : sequence_(sequence), scene_(scene), tooling_(tooling), home_(home) {}

  void timeRun(std::size_t i, TimedPiece& timed, JerkMeasure& ladder) const {
    const Run& run = sequence_.runs[i];
    const TimingLimits limits =
        timingLimits(scene_.cell, tooling_.of(scene_.plan.paths[run.path]).process);
    const std::vector<JointVector> q = jointsOf(run.points);
    std::vector<TimedPoint> points = timedPoints(scene_.cell, run.points);
    if (const auto shot = shotPoint(scene_.plan, run))
      points[*shot].stop = true;
    timed.times = timesOf(points, limits);
    if (scene_.options.maxJerk > 0.0) {
      const double before = timed.times.back();
      timed.times = timesWithinJerk(q, timed.times, limits.joints, scene_.options.maxJerk);
      timed.slowedS = timed.times.back() - before;
    }
    timed.jerk = jerkOf(q, timed.times, limits.joints);
    ladder = jerkOf(run.ladder, timed.times, limits.joints);
  }

  void timeTransfer(std::size_t i, TimedPiece& timed) const {
    RobotState from = i == 0 ? home_ : sequence_.runs[i - 1].points.back().at;
    const Transfer& transfer = sequence_.ways[i];
    std::vector<std::size_t> stops;
    for (const ToolStep& step : transfer.toolSteps)
      stops.push_back(step.point);
    stops.push_back(transfer.points.size());
    timed.times = {0.0};
    timed.jerk.maxAbs.assign(static_cast<std::size_t>(scene_.cell.dof()), 0.0);
    timed.jerk.maxAt.assign(timed.jerk.maxAbs.size(), 0);
    std::size_t first = 0;
    for (const std::size_t stop : stops) {
      if (stop == first)
        continue;
      Transfer part;
      part.points.assign(transfer.points.begin() + static_cast<std::ptrdiff_t>(first),
                         transfer.points.begin() + static_cast<std::ptrdiff_t>(stop));
      addPart(from, part, processOfTransfer(i), timed);
      from = part.points.back().at;
      first = stop;
    }
  }

private:
  int toolOf(std::size_t run) const { return scene_.plan.paths[sequence_.runs[run].path].tool; }

  // Returns the process that limits a transfer: that of its tool.
  const process::Process& processOfTransfer(std::size_t index) const {
    const bool begins = index > 0, ends = index < sequence_.runs.size();
    if (begins && ends && toolOf(index - 1) == toolOf(index))
      return tooling_.at(toolOf(index)).process;
    // From home, to home and between two tools no single tool is in use: as the first one.
    return tooling_.first().process;
  }

  // Appends a part of a transfer, from rest to rest.
  void addPart(const RobotState& from, const Transfer& part, const process::Process& process,
               TimedPiece& timed) const {
    const TimingLimits limits = timingLimits(scene_.cell, process);
    const double maxJerk = scene_.options.maxJerk, before = timed.times.back();
    const std::vector<TimedPoint> points = timedPoints(from, part, process.travelSpeedMmPerS);
    const std::vector<double> own = timesOf(points, limits);
    const std::vector<char> rests = restsAt(points, limits);
    const std::size_t atPart = timed.times.size() - 1;
    double slowed = 0.0;
    for (std::size_t first = 0, k = 1; k < own.size(); ++k) {
      if (!rests[k])
        continue;
      Between piece = between(points, own, first, k);
      if (maxJerk > 0.0)
        limitJerk(piece, limits.joints, maxJerk);
      const JerkMeasure jerk = jerkBetween(piece, limits.joints);
      for (std::size_t j = 0; j < jerk.maxAbs.size(); ++j)
        if (jerk.maxAbs[j] > timed.jerk.maxAbs[j]) {
          timed.jerk.maxAbs[j] = jerk.maxAbs[j];
          timed.jerk.maxAt[j] = atPart + first + jerk.maxAt[j];
        }
      for (std::size_t m = 1; m < piece.times.size(); ++m)
        timed.times.push_back(
            before + (maxJerk > 0.0 ? slowed + own[first] + piece.times[m] : own[first + m]));
      slowed += piece.times.back() - (own[k] - own[first]);
      first = k;
    }
    timed.slowedS += slowed;
  }

  const Sequence& sequence_;
  const MotionScene& scene_;
  const process::Tooling& tooling_;
  const RobotState& home_;
};

} // namespace

TimedSequence timesOfSequence(const Sequence& sequence, const MotionScene& scene,
                              const process::Tooling& tooling, const RobotState& home,
                              const base::RunContext& ctx) {
  const std::size_t runs = sequence.runs.size(), ways = sequence.ways.size();
  TimedSequence timed;
  timed.runs.resize(runs);
  timed.ladder.resize(runs);
  timed.ways.resize(ways);
  const SequenceTimer timer(sequence, scene, tooling, home);
  base::parallelChunks(ctx, std::max(runs, ways), 4, [&](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i) {
      if (i < runs)
        timer.timeRun(i, timed.runs[i], timed.ladder[i]);
      if (i < ways)
        timer.timeTransfer(i, timed.ways[i]);
    }
  });
  return timed;
}

} // namespace voluta::motion
