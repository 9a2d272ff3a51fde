// Joint angles as inverses give them.
#pragma once

#include "base/units.h"
#include "robot/robot_model.h"

#include <cmath>

namespace voluta::robot {

// The same turn in (-pi, pi].
inline double wrappedAngle(double angle) {
  const double rest = std::remainder(angle, base::kTurn);
  return rest <= -base::kPi ? base::kPi : rest;
}

// Are the arms' joints the same but for whole turns, each within `rad`?
inline bool sameJoints(const JointVector& a, const JointVector& b, double rad) {
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (std::abs(std::remainder(a[i] - b[i], base::kTurn)) > rad)
      return false;
  return true;
}

} // namespace voluta::robot
