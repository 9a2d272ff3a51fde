// Programs in closed form for the tests of the time-line.
#pragma once

#include "base/units.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <cmath>
#include <memory>
#include <vector>

namespace voluta::test {

struct SampleProgram {
  std::shared_ptr<plan::ToolPlan> toolPlan = std::make_shared<plan::ToolPlan>();
  std::shared_ptr<plan::Trajectory> trajectory = std::make_shared<plan::Trajectory>();
};

// `layers` layers of one path of `perLayer` waypoints, a second a waypoint, and a transfer of one
// point and a second before each path. Joint j is at sin(0.1 t + j); point 0 is at time 0.
inline SampleProgram sampleProgram(int layers, int perLayer, double stepS = 1.0, int dof = 6) {
  SampleProgram p;
  plan::ToolPlan& plan = *p.toolPlan;
  plan::Trajectory& t = *p.trajectory;
  t.dof = dof;
  const auto point = [&](plan::MoveKind kind, std::size_t waypoint) {
    const double time = stepS * static_cast<double>(t.timeS.size());
    t.timeS.push_back(time);
    t.move.push_back(kind);
    t.waypoint.push_back(waypoint);
    t.extrudedMm3.push_back(0.0);
    for (int j = 0; j < dof; ++j)
      t.joints.push_back(std::sin(0.1 * time + j));
  };
  for (int layer = 0; layer < layers; ++layer) {
    point(plan::MoveKind::Joint, plan::kNoWaypoint);
    const std::size_t first = plan.position.size();
    for (int i = 0; i < perLayer; ++i) {
      point(plan::MoveKind::Print, plan.position.size());
      plan.position.emplace_back(i, 0.0, layer);
      plan.direction.emplace_back(0.0, 0.0, 1.0);
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20.0f);
    }
    plan.paths.push_back(
        {first, static_cast<std::size_t>(perLayer), plan::PathKind::Wall, layer, layer, 0, false});
  }
  return p;
}

inline std::vector<robot::JointLimits> sampleLimits(int dof = 6) {
  const double angle = 2.0 * base::kPi;
  return std::vector<robot::JointLimits>(static_cast<std::size_t>(dof),
                                         {-angle, angle, base::kPi, 10.0});
}

} // namespace voluta::test
