// Questions to a trajectory by time: where is the robot, what is printed, which layer is it.
#pragma once

#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::timeline {

// An immutable value; every question takes O(log N). Made in O(N) (milliseconds for a million
// points), on any thread. Times outside [0, durationS()] are taken as the nearer end.
class Clock {
public:
  // Nothing moves: duration 0.
  Clock() = default;
  // Preconditions (Error{Internal}): both are there, times do not decrease, waypoints of the
  // trajectory exist in the plan.
  Clock(std::shared_ptr<const plan::Trajectory> trajectory,
        std::shared_ptr<const plan::ToolPlan> toolPlan);

  bool empty() const { return !trajectory_ || trajectory_->pointCount() == 0; }
  double durationS() const;
  std::size_t pointCount() const { return empty() ? 0 : trajectory_->pointCount(); }
  // null when empty.
  const std::shared_ptr<const plan::Trajectory>& trajectory() const { return trajectory_; }
  const std::shared_ptr<const plan::ToolPlan>& toolPlan() const { return toolPlan_; }

  // The last point reached at that time. Precondition for all that follow: not empty.
  std::size_t pointAt(double timeS) const;
  double timeOfPoint(std::size_t point) const;
  // Joints at that time, linear between points; dof values, radians (mm for sliding axes).
  robot::JointVector jointsAt(double timeS) const;

  // Number of the plan's waypoints [0, n) that are printed or passed over by then.
  std::size_t printedWaypoints(double timeS) const;
  // When the nozzle reaches a waypoint; nothing where the trajectory left it out.
  std::optional<double> timeOfWaypoint(std::size_t waypoint) const;
  // Layer (of plan::ToolPath) of the bead being laid, or last laid; before the first bead the
  // first bead's.
  int layerAt(double timeS) const;

  // Steps; the ends stay where they are.
  double nextMoveS(double timeS) const;
  double previousMoveS(double timeS) const;
  // Beginnings of the printing of a layer; one that is printed in parts begins several times.
  double nextLayerS(double timeS) const;
  double previousLayerS(double timeS) const;

private:
  struct LayerStart {
    double timeS;
    int layer;
  };

  std::shared_ptr<const plan::Trajectory> trajectory_;
  std::shared_ptr<const plan::ToolPlan> toolPlan_;
  std::vector<std::size_t> printedAt_;     // per point
  std::vector<std::size_t> waypointPoint_; // per waypoint: its point, or npos
  std::vector<LayerStart> layerStarts_;    // by time
};

} // namespace voluta::timeline
