#include "timeline/clock.h"

#include "base/error.h"
#include "plan/arrival_times.h"

#include <algorithm>
#include <limits>

namespace voluta::timeline {

namespace {
constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();

// Returns the layer of each waypoint.
std::vector<int> layersOf(const plan::ToolPlan& plan) {
  std::vector<int> layer(plan.waypointCount(), 0);
  for (const plan::ToolPath& path : plan.paths)
    std::fill_n(layer.begin() + static_cast<std::ptrdiff_t>(path.first), path.count, path.layer);
  return layer;
}
} // namespace

Clock::Clock(std::shared_ptr<const plan::Trajectory> trajectory,
             std::shared_ptr<const plan::ToolPlan> toolPlan)
    : trajectory_(std::move(trajectory)), toolPlan_(std::move(toolPlan)) {
  base::require(trajectory_ && toolPlan_, "Clock: a trajectory and its plan");
  const plan::Trajectory& t = *trajectory_;
  base::require(std::is_sorted(t.timeS.begin(), t.timeS.end()), "Clock: times do not decrease");
  timeS_ = plan::arrivalTimes(t);
  for (const plan::TrajectoryEvent& event : t.events)
    if (event.seconds > 0.0 && event.point > 0 && event.point < t.pointCount())
      addWait(event.point);
  const std::vector<int> layer = layersOf(*toolPlan_);
  printedAt_.reserve(t.pointCount());
  waypointPoint_.assign(toolPlan_->waypointCount(), kNoPoint);
  std::size_t printed = 0;
  for (std::size_t point = 0; point < t.pointCount(); ++point) {
    const std::size_t waypoint = t.waypoint[point];
    if (waypoint != plan::kNoWaypoint) {
      base::require(waypoint < waypointPoint_.size(), "Clock: the waypoint exists");
      printed = std::max(printed, waypoint + 1);
      if (waypointPoint_[waypoint] == kNoPoint)
        waypointPoint_[waypoint] = point;
      if (layerStarts_.empty() || layerStarts_.back().layer != layer[waypoint])
        layerStarts_.push_back({timeS_[point], layer[waypoint]});
    }
    printedAt_.push_back(printed);
  }
}

// The wait before the motion to a point; several events there are one wait.
void Clock::addWait(std::size_t point) {
  const double from = timeS_[point - 1], to = departureS(point);
  if (waits_.empty() || waits_.back().toS < to)
    waits_.push_back({from, to});
}

double Clock::departureS(std::size_t point) const {
  return timeS_[point] - (trajectory_->timeS[point] - trajectory_->timeS[point - 1]);
}

double Clock::durationS() const {
  return empty() ? 0.0 : timeS_.back();
}

std::size_t Clock::pointAt(double timeS) const {
  base::require(!empty(), "Clock: not empty");
  const auto after = std::upper_bound(timeS_.begin(), timeS_.end(), timeS);
  return after == timeS_.begin() ? 0 : static_cast<std::size_t>(after - timeS_.begin()) - 1;
}

double Clock::timeOfPoint(std::size_t point) const {
  base::require(point < pointCount(), "Clock: the point exists");
  return timeS_[point];
}

robot::JointVector Clock::jointsAt(double timeS) const {
  const std::size_t point = pointAt(timeS);
  const plan::Trajectory& t = *trajectory_;
  robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof);
  if (point + 1 < t.pointCount() && timeS > timeS_[point] && timeS > departureS(point + 1)) {
    const double share = (timeS - departureS(point + 1)) / (t.timeS[point + 1] - t.timeS[point]);
    q += share * (Eigen::Map<const Eigen::VectorXd>(t.at(point + 1), t.dof) - q);
  }
  return q;
}

std::size_t Clock::printedWaypoints(double timeS) const {
  return printedAt_[pointAt(timeS)];
}

std::optional<double> Clock::timeOfWaypoint(std::size_t waypoint) const {
  if (waypoint >= waypointPoint_.size() || waypointPoint_[waypoint] == kNoPoint)
    return std::nullopt;
  return timeS_[waypointPoint_[waypoint]];
}

int Clock::layerAt(double timeS) const {
  if (layerStarts_.empty())
    return 0;
  const auto after =
      std::upper_bound(layerStarts_.begin(), layerStarts_.end(), timeS,
                       [](double t, const LayerStart& start) { return t < start.timeS; });
  return after == layerStarts_.begin() ? after->layer : std::prev(after)->layer;
}

double Clock::nextMoveS(double timeS) const {
  const auto after = std::upper_bound(timeS_.begin(), timeS_.end(), timeS);
  return after == timeS_.end() ? durationS() : *after;
}

double Clock::previousMoveS(double timeS) const {
  const auto here = std::lower_bound(timeS_.begin(), timeS_.end(), timeS);
  return here == timeS_.begin() ? 0.0 : *std::prev(here);
}

double Clock::nextLayerS(double timeS) const {
  const auto after =
      std::upper_bound(layerStarts_.begin(), layerStarts_.end(), timeS,
                       [](double t, const LayerStart& start) { return t < start.timeS; });
  return after == layerStarts_.end() ? durationS() : after->timeS;
}

double Clock::previousLayerS(double timeS) const {
  const auto here =
      std::lower_bound(layerStarts_.begin(), layerStarts_.end(), timeS,
                       [](const LayerStart& start, double t) { return start.timeS < t; });
  return here == layerStarts_.begin() ? 0.0 : std::prev(here)->timeS;
}

} // namespace voluta::timeline
