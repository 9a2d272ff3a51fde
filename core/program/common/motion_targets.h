// Data of a trajectory that every writer needs: nozzle and TCP at each point, time and material of
// each motion.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::program {

struct MotionTarget {
  Eigen::Quaterniond tcpRotation; // base_T_tcp; TCP = the cell's flange_T_moved
  Eigen::Vector3d tcpMm;          // base_T_tcp
  Eigen::Vector3d tipMm;          // nozzle's tip, work frame
  Eigen::Vector3d direction;      // from the bead into the nozzle, work frame, unit
};

// Computes the target of an arm with its external axes at `q` by forward kinematics.
MotionTarget targetOf(const robot::Cell& cell, const robot::JointVector& q);

// Checks the preconditions of ProgramInput. Throws Error{Internal}.
void checkInput(const ProgramInput& input);

// Returns the targets of all points of input.trajectory. Throws Error{Internal} (preconditions of
// ProgramInput), Cancelled.
std::vector<MotionTarget> motionTargets(const ProgramInput& input, const base::RunContext& ctx);

// Converts the targets to those of the nozzle in the work frame, which is the program's work object
// whether it is fixed, rotated or held by the arm. Positions are rounded to `decimals` of a mm.
void placeInWorkFrame(const ProgramInput& input, int decimals, std::vector<MotionTarget>& targets);

// Time and material of the motion that ends at `point`; 0 at point 0.
double motionSeconds(const plan::Trajectory& trajectory, std::size_t point);
double motionVolumeMm3(const plan::Trajectory& trajectory, std::size_t point);
// Returns the largest joint displacement of the motion to `point`, including external axes [rad];
// sliding axes are converted by robot::asAngle.
double leadingJointRad(const ProgramInput& input, std::size_t point);
// Returns the speed [rad/s] at which a joint motion from rest to rest takes `seconds` (> 0), with
// ramps of `radPerS2`; the maximum speed that it reaches if it takes longer.
double rampedSpeed(double rad, double seconds, double radPerS2);
bool isPrint(const plan::Trajectory& trajectory, std::size_t point);
// Returns whether the arm has lifted off its last bead before the motion to `point`.
bool standsClear(const plan::Trajectory& trajectory, std::size_t point);

// Returns whether the extruder primes with the arm at rest at its start (plan::primesAtStart).
bool primesStanding(const ProgramInput& input);

// Names the path that begins at a point, for comments in programs.
class PathNames {
public:
  explicit PathNames(const plan::ToolPlan& toolPlan) : toolPlan_(toolPlan) {}
  // Returns "layer 3, wall, path 12", both counted from 1, if a path begins at `waypoint`,
  // otherwise an empty string. Call in print order.
  std::string at(std::size_t waypoint);

private:
  const plan::ToolPlan& toolPlan_;
  std::size_t path_ = 0;
};

} // namespace voluta::program
