// Queries on a trajectory by time: joints of the robot, printed waypoints, layer.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::timeline {

// Immutable; every query takes O(log N). Construction takes O(N) (milliseconds for a million
// points) and is possible on any thread. Times include waits, during which the arm stays where it
// is; those outside [0, durationS()] are clamped.
class Clock {
public:
  // No motion: duration 0.
  Clock() = default;
  // Preconditions (Error{Internal}): both are given, times do not decrease, and the trajectory's
  // waypoints exist in the plan.
  Clock(std::shared_ptr<const plan::Trajectory> trajectory,
        std::shared_ptr<const plan::ToolPlan> toolPlan);

  bool empty() const { return !trajectory_ || trajectory_->pointCount() == 0; }
  double durationS() const;
  std::size_t pointCount() const { return empty() ? 0 : trajectory_->pointCount(); }
  // Null if empty.
  const std::shared_ptr<const plan::Trajectory>& trajectory() const { return trajectory_; }
  const std::shared_ptr<const plan::ToolPlan>& toolPlan() const { return toolPlan_; }

  // Returns the last point reached at that time. Precondition of all following queries: not empty.
  std::size_t pointAt(double timeS) const;
  double timeOfPoint(std::size_t point) const;
  // Returns the joints at that time, linear between points; dof values [rad] (mm for sliding axes).
  robot::JointVector jointsAt(double timeS) const;

  // Returns the number n of the plan's waypoints [0, n) that are printed or passed by then.
  std::size_t printedWaypoints(double timeS) const;
  // Returns the time at which the nozzle reaches a waypoint; nullopt if the trajectory skips it.
  std::optional<double> timeOfWaypoint(std::size_t waypoint) const;
  // Returns the layer (of plan::ToolPath) of the bead being printed, or last printed; before the
  // first bead the first bead's.
  int layerAt(double timeS) const;

  struct Wait {
    double fromS, toS;
  };
  // Ascending.
  const std::vector<Wait>& waits() const { return waits_; }

  // Next and previous motion; clamped at the ends.
  double nextMoveS(double timeS) const;
  double previousMoveS(double timeS) const;
  // Start of the next and previous printing of a layer; a layer printed in parts has several
  // starts.
  double nextLayerS(double timeS) const;
  double previousLayerS(double timeS) const;

private:
  void addWait(std::size_t point);
  // Returns the time at which the motion to a point > 0 begins.
  double departureS(std::size_t point) const;

  struct LayerStart {
    double timeS;
    int layer;
  };

  std::shared_ptr<const plan::Trajectory> trajectory_;
  std::shared_ptr<const plan::ToolPlan> toolPlan_;
  std::vector<double> timeS_; // per point, waits included
  std::vector<Wait> waits_;
  std::vector<std::size_t> printedAt_;     // per point
  std::vector<std::size_t> waypointPoint_; // per waypoint: its point, or npos
  std::vector<LayerStart> layerStarts_;    // by time
};

} // namespace voluta::timeline
