#include "indicator/joint_circle.h"

#include "base/error.h"
#include "robot/angles.h"

#include <cmath>

namespace voluta::indicator {

using robot::JointKind;
using robot::JointVector;

Eigen::Index circleSize(const std::vector<robot::JointLimits>& limits) {
  Eigen::Index size = 0;
  for (const robot::JointLimits& limit : limits)
    size += limit.kind == JointKind::Turning ? 2 : 1;
  return size;
}

Eigen::VectorXd onCircle(const JointVector& q, const std::vector<robot::JointLimits>& limits) {
  base::require(q.size() == static_cast<Eigen::Index>(limits.size()), "a joint for each limit");
  Eigen::VectorXd point(circleSize(limits));
  Eigen::Index k = 0;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const JointKind kind = limits[static_cast<std::size_t>(j)].kind;
    if (kind == JointKind::Turning) {
      point[k++] = std::cos(q[j]);
      point[k++] = std::sin(q[j]);
    } else {
      point[k++] = robot::asAngle(kind, q[j]);
    }
  }
  return point;
}

JointVector jointMidpoint(const JointVector& a, const JointVector& b,
                          const std::vector<robot::JointLimits>& limits) {
  JointVector q = a;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double step = b[j] - a[j];
    if (limits[static_cast<std::size_t>(j)].kind == JointKind::Turning)
      q[j] = robot::wrappedAngle(a[j] + 0.5 * robot::wrappedAngle(step));
    else
      q[j] = a[j] + 0.5 * step;
  }
  return q;
}

} // namespace voluta::indicator
