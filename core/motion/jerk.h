// Jerk of joints over possibly uneven times: third differences, linear in the joints.
#pragma once

#include "robot/robot_model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::motion {

// The weights of the joints at points last - 3 .. last in one jerk; points before the first do not
// count.
struct JerkStencil {
  std::size_t last = 0;
  std::array<double, 4> weight{};
};

// Returns the jerks of a stretch from rest to rest over these increasing times [s]: velocities at
// the middles of steps, accelerations between those, jerks between these. One per time; the last
// assumes the joints at rest after the last point.
std::vector<JerkStencil> jerkStencils(const std::vector<double>& times);

// Jerk of the joints over a stretch from rest to rest, computed with jerkStencils().
struct JerkMeasure {
  std::vector<double> maxAbs;     // Per joint [rad/s3]; sliding joints [mm/s3]
  std::vector<std::size_t> maxAt; // The point at which each joint has it
  double sumSquared = 0.0; // Over all points and joints [(rad/s3)2]; sliding joints by asAngle()
};
// `q`: the joints at each time. Joints without an entry in `limits` count as turning.
JerkMeasure jerkOf(const std::vector<robot::JointVector>& q, const std::vector<double>& times,
                   const std::vector<robot::JointLimits>& limits = {});

} // namespace voluta::motion
