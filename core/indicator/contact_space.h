// The joints with which an arm's nozzle touches a layer: the contact configuration space of the
// surface that its waypoints lie on. Source: Dai 2020, 4.4.2, eq. 4.15.
#pragma once

#include "plan/tool_plan.h"
#include "robot/cell.h"
#include "robot/kinematics/arm_twists.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::indicator {

class ContactSpace {
public:
  // Waypoints [first, first + count) of the plan; the surface is what lies within a bead of
  // one, on the plane across its direction. Cell and plan outlive this. Preconditions: count > 0,
  // inside the plan; the cell has no external axes.
  ContactSpace(const robot::Cell& cell, const plan::ToolPlan& plan, std::size_t first,
               std::size_t count);

  // At least `count` joints: the nozzle along its direction at random waypoints, turned about
  // itself by random angles, all branches of the inverse. Fewer where 50 times as many waypoints
  // were tried: most are out of reach.
  std::vector<robot::JointVector> random(std::size_t count, std::uint64_t seed) const;

  // Of the tip from the surface, mm.
  double distanceMm(const robot::JointVector& q) const;
  // Near to the nearest joints (by their turns, rad) at which the tip is within 0.05 mm of the
  // surface, wherever the nozzle points: Newton's steps on the distance, each the least that does.
  // Nothing where twenty steps do not come there. Joints may leave their limits.
  std::optional<robot::JointVector> project(const robot::JointVector& q) const;

private:
  // From the tip to the nearest of the surface, work frame, mm.
  Eigen::Vector3d missing(const Eigen::Vector3d& tip) const;

  const robot::Cell& cell_;
  const plan::ToolPlan& plan_;
  std::size_t first_, count_;
  robot::ArmTwists twists_;
};

} // namespace voluta::indicator
