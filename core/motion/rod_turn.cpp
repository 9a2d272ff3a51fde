#include "motion/rod_turn.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kAlongRod = 1e-6; // part of a unit direction across the rod that says nothing

double onStep(const robot::ExternalAxis& axis, double angle) {
  return axis.stepRad > 0.0 ? axis.stepRad * std::round(angle / axis.stepRad) : angle;
}

// Angle about x, from y to z.
double angleOf(const Vector3d& v) {
  return std::atan2(v.z(), v.y());
}

} // namespace

double rodAngle(const robot::Cell& cell, const JointVector& q) {
  return cell.externalAxes().empty() ? 0.0 : q[cell.armDof()];
}

JointVector withRod(const robot::Cell& cell, JointVector q, double angleRad) {
  if (!cell.externalAxes().empty())
    q[cell.armDof()] = onStep(cell.externalAxes().front(), angleRad);
  return q;
}

JointVector armOf(const robot::Cell& cell, const JointVector& q) {
  return q.head(cell.armDof());
}

Vector3d turnedByRod(const Vector3d& v, double angleRad) {
  const double c = std::cos(angleRad), s = std::sin(angleRad);
  return {v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z()};
}

std::vector<double> uprightAngles(const plan::ToolPlan& plan, const robot::Cell& cell,
                                  std::size_t first, std::size_t count, double nearRad) {
  base::require(!cell.externalAxes().empty(), "a rod that turns");
  const robot::ExternalAxis& axis = cell.externalAxes().front();
  const double up = angleOf(cell.base_T_fixed().linear().transpose() * Vector3d::UnitZ());
  std::vector<double> angles(count);
  double last = nearRad;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d& d = plan.direction[first + i];
    if (std::hypot(d.y(), d.z()) > kAlongRod) {
      const double wanted = up - angleOf(d);
      last = wanted + base::kTurn * std::round((last - wanted) / base::kTurn);
    }
    angles[i] = last;
  }

  // Half a step more than the limits allow: rounding may go either way.
  const double low = axis.limits.min + 0.5 * axis.stepRad;
  const double high = axis.limits.max - 0.5 * axis.stepRad;
  const auto reach = [&](double offset) {
    std::size_t n = 0;
    while (n < count && angles[n] + offset >= low && angles[n] + offset <= high)
      ++n;
    return n;
  };
  std::size_t best = reach(0.0);
  double offset = 0.0;
  if (best < count) {
    const auto turns = static_cast<int>(std::ceil((high - low) / base::kTurn)) + 1;
    for (int k = 1; k <= turns && best < count; ++k)
      for (const double sign : {-1.0, 1.0}) {
        const std::size_t n = reach(sign * k * base::kTurn);
        if (n > best) {
          best = n;
          offset = sign * k * base::kTurn;
        }
      }
  }
  angles.resize(best);
  for (double& a : angles)
    a += offset;
  return angles;
}

JointVector homeAfter(const robot::Cell& cell, const JointVector& q) {
  if (cell.externalAxes().empty() || !cell.externalAxes().front().runsOn)
    return cell.home();
  return withRod(cell, cell.home(), base::kTurn * std::round(rodAngle(cell, q) / base::kTurn));
}

} // namespace voluta::motion
