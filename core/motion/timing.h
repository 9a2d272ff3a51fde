// Timing of motions: a trapezoidal velocity profile with look-ahead.
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
  double cornerMm = 0.05;     // maximum deviation at a corner, which limits the speed through it
  double jointFraction = 0.9; // usable share of the velocity and acceleration limits
  // Acceleration of the arm's joints in joint moves [rad/s2], sliding ones by robot::asAngle; 0: as
  // in all other moves.
  double travelRadPerS2 = 0.0;
  // number of the arm's joints, which come first, followed by a rod's; 0: all are the arm's
  int arm = 0;
};

// A point of a motion and the move that reaches it from the preceding point.
struct TimedPoint {
  robot::JointVector q;
  Eigen::Vector3d tip = Eigen::Vector3d::Zero(); // work frame [mm]
  double speedMmPerS = 0.0; // wanted tip speed of the move; unused for joint moves
  bool jointMove = false;
  bool stop = false; // rests here; the first and the last point always do
  // Displacement of each joint during the move if it moved at its peak speed throughout. Empty:
  // constant speed.
  robot::JointVector peakDisplacement = {};
};

// Returns the times [s] from the first point (0) to each point. Between points the tip (or the
// arm's fastest joint where the tip hardly moves) follows speed ramps of at most
// accelerationMmPerS2, and at most the acceleration that a rod turning along allows. Speeds are
// limited to the wanted ones, to those at which every joint keeps its velocity limit, and at
// corners to those of a circle that deviates from the corner by cornerMm. Speeds are then lowered
// until every joint's acceleration (difference of the mean velocities of two consecutive segments
// over the time between their midpoints) keeps its limit. Between joint moves that are not
// collinear in joint space the arm stops, as with real controllers. Precondition: limits for every
// joint, all positive.
std::vector<double> timesOf(const std::vector<TimedPoint>& points, const TimingLimits& limits);

// Returns, for each point, whether the motion rests there. Same precondition.
std::vector<char> restsAt(const std::vector<TimedPoint>& points, const TimingLimits& limits);

} // namespace voluta::motion
