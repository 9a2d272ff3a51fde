// What every writer needs of a trajectory: where the nozzle and the TCP are at each point, and the
// time and material of each motion.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::program {

struct MotionTarget {
  Eigen::Quaterniond tcpTurn; // base_T_tcp; TCP = the cell's flange_T_moved
  Eigen::Vector3d tcpMm;      // base_T_tcp
  Eigen::Vector3d tipMm;      // nozzle's tip, work frame
  Eigen::Vector3d direction;  // from the bead into the nozzle, work frame, unit
};

// Of an arm, with its external axes, that stands there; by forward kinematics.
MotionTarget targetOf(const robot::Cell& cell, const robot::JointVector& q);

// The preconditions of ProgramInput. Throws Error{Internal}.
void checkInput(const ProgramInput& input);

// Targets of all points of input.trajectory.
// Throws Error{Internal} (preconditions of ProgramInput), Cancelled.
std::vector<MotionTarget> motionTargets(const ProgramInput& input, const base::RunContext& ctx);

// Makes the targets those of the nozzle in the work frame, which a program has for its work object
// whether that stands, turns or is held; positions rounded to `decimals` of a mm.
void placeInWorkFrame(const ProgramInput& input, int decimals, std::vector<MotionTarget>& targets);

// Time and material of the motion that ends at `point`; 0 at point 0.
double motionSeconds(const plan::Trajectory& trajectory, std::size_t point);
double motionVolumeMm3(const plan::Trajectory& trajectory, std::size_t point);
// How far the axis that goes furthest, of the arm and beside it, goes in it, rad; sliding ones by
// robot::asTurn.
double leadingJointRad(const ProgramInput& input, std::size_t point);
// The speed at which a joint motion from rest to rest takes `seconds` (> 0), with ramps of
// `radPerS2`; the greatest that it gets to, where it takes longer. rad/s.
double rampedSpeed(double rad, double seconds, double radPerS2);
bool isPrint(const plan::Trajectory& trajectory, std::size_t point);
// Before the motion to `point` the arm has lifted off its last bead.
bool standsClear(const plan::Trajectory& trajectory, std::size_t point);

// Flow of the prime: a bead of the process's default section at its default speed, at most the
// extruder's full flow.
double primeFlowMm3PerS(const process::Process& process);
// Does the extruder fill the nozzle where the arm stands at its start? Not where a path does.
bool primesStanding(const ProgramInput& input);

// Says, for the comments of a program, which path begins at a point.
class PathNames {
public:
  explicit PathNames(const plan::ToolPlan& toolPlan) : toolPlan_(toolPlan) {}
  // "layer 3, wall, path 12" if a path begins at `waypoint`, else empty. To be asked in print
  // order.
  std::string at(std::size_t waypoint);

private:
  const plan::ToolPlan& toolPlan_;
  std::size_t path_ = 0;
};

} // namespace voluta::program
