#include "motion/external_axes.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Vector3d;
using robot::JointVector;

namespace {

// Component of a unit direction perpendicular to the rod below which it has no angle
constexpr double kAlongRod = 1e-6;

double onStep(const robot::ExternalAxis& axis, double value) {
  return axis.step > 0.0 ? axis.step * std::round(value / axis.step) : value;
}

// Returns v rotated about x.
Vector3d turnedAboutX(const Vector3d& v, double angleRad) {
  const double c = std::cos(angleRad), s = std::sin(angleRad);
  return {v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z()};
}

// Returns the transform from an axis' moving frame to the next axis or the work frame.
const Eigen::Isometry3d& behind(const robot::Cell& cell, std::size_t axis) {
  return axis + 1 < cell.externalAxes().size() ? cell.externalAxes()[axis + 1].before_T_axis
                                               : cell.axis_T_work();
}

// Returns the angle about x, from y towards z.
double angleOf(const Vector3d& v) {
  return std::atan2(v.z(), v.y());
}

} // namespace

JointVector axesOf(const robot::Cell& cell, const JointVector& q) {
  return q.tail(q.size() - cell.armDof());
}

JointVector withAxes(const robot::Cell& cell, JointVector q, const JointVector& axes) {
  for (Eigen::Index k = 0; k < axes.size(); ++k)
    q[cell.armDof() + k] = onStep(cell.externalAxes()[static_cast<std::size_t>(k)], axes[k]);
  return q;
}

Eigen::Quaterniond axesRotation(const robot::Cell& cell, const JointVector& axes) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (std::size_t k = 0; k < cell.externalAxes().size(); ++k) {
    const double half = 0.5 * axes[static_cast<Eigen::Index>(k)];
    if (cell.externalAxes()[k].limits.kind == robot::JointKind::Turning)
      rotation = rotation * Eigen::Quaterniond(std::cos(half), std::sin(half), 0.0, 0.0);
    rotation = rotation * Eigen::Quaterniond(behind(cell, k).linear());
  }
  return rotation;
}

Vector3d turnedByAxes(const robot::Cell& cell, const Vector3d& direction, const JointVector& axes) {
  Vector3d v = direction;
  for (std::size_t k = cell.externalAxes().size(); k-- > 0;) {
    v = behind(cell, k).linear() * v;
    if (cell.externalAxes()[k].limits.kind == robot::JointKind::Turning)
      v = turnedAboutX(v, axes[static_cast<Eigen::Index>(k)]);
  }
  return v;
}

Vector3d movedByAxes(const robot::Cell& cell, const Vector3d& point, const JointVector& axes) {
  Vector3d p = point;
  for (std::size_t k = cell.externalAxes().size(); k-- > 0;) {
    p = behind(cell, k) * p;
    if (cell.externalAxes()[k].limits.kind == robot::JointKind::Turning)
      p = turnedAboutX(p, axes[static_cast<Eigen::Index>(k)]);
    else
      p.x() += axes[static_cast<Eigen::Index>(k)];
  }
  return p;
}

AxisTwists axisTwists(const robot::Cell& cell, const JointVector& axes, const Vector3d& point) {
  AxisTwists twists(6, axes.size());
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (Eigen::Index k = 0; k < axes.size(); ++k) {
    const robot::ExternalAxis& axis = cell.externalAxes()[static_cast<std::size_t>(k)];
    frame = frame * axis.before_T_axis;
    const Vector3d along = frame.linear().col(0);
    if (axis.limits.kind == robot::JointKind::Turning)
      twists.col(k) << along.cross(point - frame.translation()), along;
    else
      twists.col(k) << along, Vector3d::Zero();
    frame = frame * robot::movedBy(axis, axes[k]);
  }
  return twists;
}

std::vector<double> uprightAngles(const plan::ToolPlan& plan, const robot::Cell& cell,
                                  std::size_t first, std::size_t count, double nearRad) {
  base::require(cell.rod().has_value(), "a rod that turns");
  const robot::ExternalAxis& axis = cell.externalAxes().front();
  const double up = angleOf(cell.base_T_fixed().linear().transpose() * Vector3d::UnitZ());
  std::vector<double> angles(count);
  double last = nearRad;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d& d = plan.direction[first + i];
    if (std::hypot(d.y(), d.z()) > kAlongRod) {
      const double wanted = up - angleOf(d);
      last = wanted + base::kTwoPi * std::round((last - wanted) / base::kTwoPi);
    }
    angles[i] = last;
  }

  // Half a step inside the limits, since rounding may go either way.
  const double low = axis.limits.min + 0.5 * axis.step;
  const double high = axis.limits.max - 0.5 * axis.step;
  const auto reach = [&](double offset) {
    std::size_t n = 0;
    while (n < count && angles[n] + offset >= low && angles[n] + offset <= high)
      ++n;
    return n;
  };
  std::size_t best = reach(0.0);
  double offset = 0.0;
  if (best < count) {
    const auto turns = static_cast<int>(std::ceil((high - low) / base::kTwoPi)) + 1;
    for (int k = 1; k <= turns && best < count; ++k)
      for (const double sign : {-1.0, 1.0}) {
        const std::size_t n = reach(sign * k * base::kTwoPi);
        if (n > best) {
          best = n;
          offset = sign * k * base::kTwoPi;
        }
      }
  }
  angles.resize(best);
  for (double& a : angles)
    a += offset;
  return angles;
}

JointVector homeAfter(const robot::Cell& cell, const JointVector& q) {
  JointVector rest = cell.home();
  for (std::size_t k = 0; k < cell.externalAxes().size(); ++k) {
    const robot::ExternalAxis& axis = cell.externalAxes()[k];
    const Eigen::Index at = cell.armDof() + static_cast<Eigen::Index>(k);
    if (axis.runsOn)
      rest[at] = onStep(axis, base::kTwoPi * std::round(q[at] / base::kTwoPi));
  }
  return rest;
}

} // namespace voluta::motion
