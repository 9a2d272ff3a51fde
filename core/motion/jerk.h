// Jerk of joints over times that need not be even: third differences, linear in the joints.
#pragma once

#include "robot/robot_model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// What the points' joints count in one jerk: those of points last - 3 .. last, where there are
// such.
struct JerkStencil {
  std::size_t last = 0;
  std::array<double, 4> weight{};
};

// The jerks of a stretch from rest to rest over those times (s, rising): velocities at the middles
// of steps, accelerations between those, jerks between these; one a time, the last with the joints
// at rest behind the last point.
std::vector<JerkStencil> jerkStencils(const std::vector<double>& times);

// Weights of points i - 2 .. i + 2 in the third derivative at times[i] of the quartic through them
// (Dai 2020, eqs. 4.7-4.10; on even times eq. 4.11). It does not see points that go to and fro by
// turns, which jerkStencils() does. Precondition: 2 <= i, i + 2 < times.size(); times rise.
std::array<double, 5> fivePointJerk(const std::vector<double>& times, std::size_t i);

// Jerk of the joints over a stretch from rest to rest, by jerkStencils().
struct JerkMeasure {
  std::vector<double> maxAbs; // a joint, rad/s3; mm/s3 of a sliding one
  double sumSquared = 0.0;    // over all points and joints, (rad/s3)2; sliding ones by asTurn()
};
// `q`: joints a time. Joints without limits here turn.
JerkMeasure jerkOf(const std::vector<robot::JointVector>& q, const std::vector<double>& times,
                   const std::vector<robot::JointLimits>& limits = {});

} // namespace voluta::motion
