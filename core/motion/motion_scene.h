// Inputs shared by the planners of one job, and how finely their moves are divided.
#pragma once

#include "motion/bead_run.h"
#include "robot/cell.h"
#include "robot/kinematics/arm_twists.h"

#include <vector>

namespace voluta::collision {
class CellCollision;
class GrowingPart;
} // namespace voluta::collision
namespace voluta::plan {
struct ToolPlan;
}

namespace voluta::motion {

struct MotionOptions;

// Returns the lever of each external axis: the maximum distance by which a rotation moves its load
// [mm/rad]; 1 for a sliding axis. For a rod only the printed part counts, for other axes also the
// bodies that they move.
std::vector<double> leversOf(const plan::ToolPlan& plan, const robot::Cell& cell);

// All referenced objects must outlive it.
struct MotionScene {
  const plan::ToolPlan& plan;
  const robot::Cell& cell;
  const collision::CellCollision& collision;
  const collision::GrowingPart& part;
  const MotionOptions& options;

  // Returns an upper bound [mm] for the nozzle's deviation from its straight path on the part when
  // flange poses are interpolated between two tips over a rotation of `angle`. With the plate on
  // the flange tip(t) = R(t)^T (n - o(t)), o straight and R uniform: its second derivative is the
  // tip's swing about the plate's centre and twice rotation times travel, an eighth of which is the
  // sagitta.
  double bend(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double angle) const;
  // Returns the number of steps into which such a move must be divided.
  int divisions(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double angle) const;

  // Returns the joint distance that matters for checks between two poses [rad]: the largest joint
  // step of the arm (sliding joints by robot::asAngle), or the distance by which external axes move
  // the part, where that is further than a joint would move it at an arm's lever.
  double span(const robot::JointVector& a, const robot::JointVector& b) const;

  // Returns ArmTwists::singularSide.
  int sideOf(const robot::JointVector& q) const;
  // Returns whether a controller that moves the nozzle straight from one state to the other, in
  // small steps to the nearest joints each time, reaches the joints of the other state without a
  // detour. False if the path passes beside a singular pose and the two states are on different
  // sides of it: a joint would race, or the motion would end in another configuration.
  bool movesStraight(const RobotState& from, const RobotState& to) const;

  std::vector<double> leversMm = {}; // Of the external axes: leversOf
  robot::ArmTwists twists = robot::ArmTwists(*cell.robot().kinematics);
};

// Finds the joints that bring the nozzle there, nearest to `near` (largest step of the arm's joints
// [rad], sliding ones by robot::asAngle). Returns false if there are none within maxStep. `scratch`
// is memory for the call.
bool solveNear(const robot::Cell& cell, const Eigen::Vector3d& tip, const Eigen::Quaterniond& tool,
               const robot::JointVector& near, double maxStep,
               std::vector<robot::JointVector>& scratch, robot::JointVector& q);

} // namespace voluta::motion
