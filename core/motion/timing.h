// When the robot is where: a trapezoidal profile with look-ahead.
#pragma once

#include "plan/trajectory.h"
#include "robot/robot_model.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::motion {

struct TimingLimits {
  std::vector<robot::JointLimits> joints;
  double accelerationMmPerS2 = 500.0;
  double cornerMm = 0.05;     // how far a corner may be cut, for the speed through it
  double jointFraction = 0.9; // of velocity and acceleration limits that is used
  // Of the arm's joints in joint moves, rad/s2, sliding ones by robot::asTurn; 0: as in all others.
  double travelRadPerS2 = 0.0;
  int arm = 0; // the first so many joints are the arm's, those behind them a rod's; 0: all are
};

// A point of a motion and how it is to be reached from the one before.
struct TimedPoint {
  robot::JointVector q;
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); // work frame, mm
  double speedMmPerS = 0.0; // wanted tip speed on the way here; unused for joint moves
  bool jointMove = false;
  bool stop = false; // comes to rest here; first and last point always do
  // How far each joint would go on the way here if it went all the way as fast as where it goes
  // fastest. Empty: evenly.
  robot::JointVector most = {};
};

// Seconds from the first point (0) to each. Between points the tip (or the arm's fastest joint,
// where the tip hardly moves) follows speed ramps of at most accelerationMmPerS2, and of what a rod
// allows that turns with it; speeds are at most the wanted ones, those at which every joint keeps
// its velocity limit, and at corners those of a circle that cuts the corner by cornerMm. Then
// speeds are lowered until every joint's acceleration, from one step's mean velocity to the next
// one's over the time between their middles, keeps its limit. Between joint moves that do not go on
// along one line in joint space the arm stands, as controllers do. Precondition: limits for every
// joint, all positive.
std::vector<double> timesOf(const std::vector<TimedPoint>& points, const TimingLimits& limits);

} // namespace voluta::motion
