// What planners of one job share, and how finely a move of theirs is to be divided.
#pragma once

#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "motion/run.h"
#include "plan/tool_plan.h"
#include "robot/cell.h"
#include "robot/kinematics/arm_twists.h"

#include <vector>

namespace voluta::motion {

// How far each external axis' turn takes what it moves at most, mm a radian; 1 of one that slides.
// Of a rod what is printed counts, of others also the bodies that they move.
std::vector<double> leversOf(const plan::ToolPlan& plan, const robot::Cell& cell);

// All referenced objects outlive it.
struct MotionScene {
  const plan::ToolPlan& plan;
  const robot::Cell& cell;
  const collision::CellCollision& collision;
  const collision::GrowingPart& part;
  const MotionOptions& options;

  // At most how far the nozzle leaves its straight way on the part, in mm, where flange poses are
  // interpolated between two tips over a turn of `angle`. With the plate on the flange
  // tip(t) = R(t)^T (n - o(t)), o straight and R even: its second derivative is the tip's swing
  // about the plate's centre and twice turn times travel, an eighth of which is the sagitta.
  double bend(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double angle) const;
  // Into how many steps such a move is to be divided.
  int divisions(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double angle) const;

  // How far joints are apart for whoever looks between them, rad: the largest step of the arm's
  // (sliding ones by robot::asTurn), or what external axes take the part, where that is further
  // than a joint would at an arm's lever.
  double span(const robot::JointVector& a, const robot::JointVector& b) const;

  // ArmTwists::singularSide.
  int sideOf(const robot::JointVector& q) const;
  // Does a controller that takes the nozzle straight from one state to the other, in small steps
  // and each time to the joints next to those before, come to those of the other without a detour?
  // Not where it passes beside a singular pose and the two are on different sides of that: a joint
  // would race, or all end elsewhere.
  bool goesStraight(const RobotState& from, const RobotState& to) const;

  std::vector<double> leversMm = {}; // of the external axes: leversOf
  robot::ArmTwists twists = robot::ArmTwists(*cell.robot().kinematics);
};

// The joints that bring the nozzle there, nearest to `near` (largest step of the arm's, rad,
// sliding ones by robot::asTurn); false when there are none within maxStep. `scratch` is memory for
// the call.
bool solveNear(const robot::Cell& cell, const Eigen::Vector3d& tip, const Eigen::Quaterniond& tool,
               const robot::JointVector& near, double maxStep,
               std::vector<robot::JointVector>& scratch, robot::JointVector& q);

} // namespace voluta::motion
