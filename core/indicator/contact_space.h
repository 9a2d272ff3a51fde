// The joints with which an arm's nozzle touches a layer: the contact configuration space of the
// surface of its waypoints. Source: Dai 2020, 4.4.2, eq. 4.15.
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
  // Uses waypoints [first, first + count) of the plan; the surface consists of the points within a
  // bead of a waypoint, on the plane perpendicular to its direction. Cell and plan must outlive
  // this. Preconditions: count > 0, inside the plan; the cell has no external axes.
  ContactSpace(const robot::Cell& cell, const plan::ToolPlan& plan, std::size_t first,
               std::size_t count);

  // Returns at least `count` joint vectors: the nozzle along its direction at random waypoints,
  // rotated about itself by random angles, all IK branches. Returns fewer after 50 times as many
  // tried waypoints, since most are out of reach.
  std::vector<robot::JointVector> random(std::size_t count, std::uint64_t seed) const;

  // Returns the distance of the tip from the surface [mm].
  double distanceMm(const robot::JointVector& q) const;
  // Returns joints close to q (by their rotations, rad) at which the tip is within 0.05 mm of the
  // surface, for any direction of the nozzle: Newton steps on the distance, each of minimum norm.
  // Returns nullopt if twenty steps do not suffice. Joints may leave their limits.
  std::optional<robot::JointVector> project(const robot::JointVector& q) const;

private:
  // Returns the vector from the tip to the nearest point of the surface, work frame [mm].
  Eigen::Vector3d missing(const Eigen::Vector3d& tip) const;

  const robot::Cell& cell_;
  const plan::ToolPlan& plan_;
  std::size_t first_, count_;
  robot::ArmTwists twists_;
};

} // namespace voluta::indicator
