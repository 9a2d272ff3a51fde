// Normalization and comparison of joint angles.
#pragma once

#include "base/units.h"
#include "robot/robot_model.h"

#include <cmath>

namespace voluta::robot {

// Returns the equivalent angle in (-pi, pi].
inline double wrappedAngle(double angle) {
  const double rest = std::remainder(angle, base::kTwoPi);
  return rest <= -base::kPi ? base::kPi : rest;
}

// Returns whether the arm's joints are the same up to whole turns, each within `rad`.
inline bool sameJoints(const JointVector& a, const JointVector& b, double rad) {
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (std::abs(std::remainder(a[i] - b[i], base::kTwoPi)) > rad)
      return false;
  return true;
}

} // namespace voluta::robot
