// Joint values as people write them.
#pragma once

#include "base/units.h"
#include "robot/robot_model.h"

#include <initializer_list>

namespace voluta::test {

inline robot::JointVector joints(std::initializer_list<double> deg) {
  robot::JointVector q(static_cast<Eigen::Index>(deg.size()));
  Eigen::Index i = 0;
  for (double d : deg)
    q[i++] = base::degreesToRadians(d);
  return q;
}

} // namespace voluta::test
