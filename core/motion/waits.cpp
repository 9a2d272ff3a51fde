#include "motion/waits.h"

#include "collision/bead_samples.h"
#include "plan/waypoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::motion {

namespace {
using collision::BeadSample, collision::BeadSampleGrid;
using Eigen::Vector3d;
using plan::MoveKind;

// Points [first, end) of the trajectory that print without lifting, without the one they start at.
struct PrintedRun {
  std::size_t first = 0, end = 0;
};

std::vector<PrintedRun> printedRuns(const plan::Trajectory& t) {
  std::vector<PrintedRun> runs;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.move[i] != MoveKind::Print)
      continue;
    if (t.move[i - 1] != MoveKind::Print)
      runs.push_back({i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

// A sample with the times of the motion alone.
struct TimedSample {
  BeadSample bead;
  double beginS = 0.0, endS = 0.0;
};

// Returns the samples of a run's beads, without waste.
std::vector<TimedSample> samplesOf(const PrintedRun& run, const plan::ToolPlan& plan,
                                   const plan::Trajectory& t) {
  std::vector<TimedSample> timed;
  std::vector<BeadSample> samples;
  std::size_t last = run.first - 1; // point at a waypoint
  for (std::size_t i = run.first; i < run.end; ++i) {
    const std::size_t a = t.waypoint[last], b = t.waypoint[i];
    if (b == plan::kNoWaypoint)
      continue;
    const double begin = t.timeS[last], seconds = t.timeS[i] - begin;
    last = i;
    if (a == plan::kNoWaypoint || plan::isWaste(plan::pathOf(plan, b)->kind))
      continue;
    samples.clear();
    collision::appendSamples(plan, a, b, samples);
    for (const BeadSample& sample : samples)
      timed.push_back({sample, begin + sample.from * seconds, begin + sample.to * seconds});
  }
  return timed;
}

class WaitPlanner {
public:
  WaitPlanner(const plan::ToolPlan& plan, const plan::Trajectory& trajectory,
              const robot::Cell& cell, double minS)
      : plan_(plan), trajectory_(trajectory), cell_(cell), minS_(minS), grid_(plan) {}

  std::vector<plan::TrajectoryEvent> plan() {
    const std::vector<PrintedRun> runs = printedRuns(trajectory_);
    std::vector<plan::TrajectoryEvent> waits;
    double waited = 0.0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::vector<TimedSample> samples = samplesOf(runs[r], plan_, trajectory_);
      if (const double wait = waitBefore(samples, waited); wait > 0.0) {
        const std::size_t before = r > 0 ? runs[r - 1].end : 1;
        waits.push_back({.point = placeOfWait(before, runs[r].first),
                         .kind = plan::EventKind::Wait,
                         .seconds = wait});
        waited += wait;
      }
      for (const TimedSample& sample : samples) {
        grid_.add(sample.bead);
        endS_.push_back(sample.endS + waited);
      }
    }
    return waits;
  }

private:
  // Returns the wait that a run needs, in milliseconds as programs state it. `waitedS`: before it.
  double waitBefore(const std::vector<TimedSample>& samples, double waitedS) const {
    double wait = 0.0;
    for (const TimedSample& sample : samples)
      grid_.below(sample.bead, [&](std::size_t lower) {
        wait = std::max(wait, endS_[lower] + minS_ - sample.beginS - waitedS);
      });
    constexpr double kPerS = 1000.0;
    return std::ceil(wait * kPerS) / kPerS;
  }

  // Returns the point that follows a wait on the travel between the points `before` - 1, where the
  // last bead ends, and `first` - 1, where the next one begins.
  std::size_t placeOfWait(std::size_t before, std::size_t first) const {
    const Eigen::Isometry3d end = poseAt(before - 1), begin = poseAt(first - 1);
    std::size_t highest = first - 1;
    double maximum = 0.0;
    for (std::size_t i = before; i + 1 < first; ++i) {
      const Vector3d tip = poseAt(i).translation();
      const double height = std::min(heightAbove(end, tip), heightAbove(begin, tip));
      constexpr double kSameMm = 1e-3; // of two such points the later one
      if (height < maximum - kSameMm)
        continue;
      maximum = std::max(maximum, height);
      highest = i + 1;
    }
    return std::max<std::size_t>(highest, 1);
  }
  Eigen::Isometry3d poseAt(std::size_t point) const {
    return cell_.work_T_tool(Eigen::Map<const Eigen::VectorXd>(
        trajectory_.at(point), static_cast<Eigen::Index>(trajectory_.dof)));
  }
  static double heightAbove(const Eigen::Isometry3d& pose, const Vector3d& tip) {
    return -(tip - pose.translation()).dot(pose.linear().col(2));
  }

  const plan::ToolPlan& plan_;
  const plan::Trajectory& trajectory_;
  const robot::Cell& cell_;
  double minS_;
  BeadSampleGrid grid_;
  std::vector<double> endS_; // per sample in the grid, waits included
};

} // namespace

std::vector<plan::TrajectoryEvent> waitsToCool(const plan::ToolPlan& plan,
                                               const plan::Trajectory& trajectory,
                                               const robot::Cell& cell, double minS) {
  return WaitPlanner(plan, trajectory, cell, minS).plan();
}

std::vector<float> layerTimesOf(const plan::ToolPlan& plan, const plan::Trajectory& trajectory) {
  std::vector<float> times(plan.waypointCount(), -1.0F);
  BeadSampleGrid grid(plan);
  std::vector<double> endS;
  double waited = 0.0;
  auto event = trajectory.events.begin();
  for (const PrintedRun& run : printedRuns(trajectory)) {
    for (; event != trajectory.events.end() && event->point <= run.first; ++event)
      waited += event->seconds;
    for (const TimedSample& sample : samplesOf(run, plan, trajectory)) {
      float& time = times[sample.bead.waypoint];
      grid.below(sample.bead, [&](std::size_t lower) {
        const auto since = static_cast<float>(sample.beginS + waited - endS[lower]);
        time = time < 0.0F ? since : std::min(time, since);
      });
      grid.add(sample.bead);
      endS.push_back(sample.endS + waited);
    }
  }
  return times;
}

} // namespace voluta::motion
