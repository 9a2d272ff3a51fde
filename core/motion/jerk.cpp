#include "motion/jerk.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

std::vector<JerkStencil> jerkStencils(const std::vector<double>& times) {
  using Weights = std::array<double, 4>;
  const auto differences = [](const Weights& a, const Weights& b, double over) {
    Weights d;
    for (std::size_t k = 0; k < 4; ++k)
      d[k] = (a[k] - b[k]) / over;
    return d;
  };
  // Returns the weights of the previous step relative to the step after it: each moves back by one
  // point.
  const auto shifted = [](const Weights& w) { return Weights{w[1], w[2], w[3], 0.0}; };
  std::vector<JerkStencil> stencils;
  const std::size_t n = times.size();
  if (n == 0)
    return stencils;
  Weights velocity{}, acceleration{};
  double middle = times[0], at = times[0];
  for (std::size_t i = 1; i <= n; ++i) {
    Weights newVelocity{};
    double newMiddle = times[n - 1];
    if (i < n) {
      const double dt = times[i] - times[i - 1];
      base::require(dt > 0.0, "jerkStencils: times rise");
      newVelocity[3] = 1.0 / dt;
      newVelocity[2] = -1.0 / dt;
      newMiddle = 0.5 * (times[i] + times[i - 1]);
    }
    if (newMiddle <= middle)
      continue;
    const Weights newAcceleration = differences(newVelocity, shifted(velocity), newMiddle - middle);
    const double newAt = 0.5 * (newMiddle + middle);
    stencils.push_back({i, differences(newAcceleration, shifted(acceleration), newAt - at)});
    velocity = newVelocity;
    acceleration = newAcceleration;
    middle = newMiddle;
    at = newAt;
  }
  return stencils;
}

JerkMeasure jerkOf(const std::vector<robot::JointVector>& q, const std::vector<double>& times,
                   const std::vector<robot::JointLimits>& limits) {
  JerkMeasure measure;
  if (q.empty())
    return measure;
  const auto dof = static_cast<std::size_t>(q.front().size());
  measure.maxAbs.assign(dof, 0.0);
  measure.maxAt.assign(dof, 0);
  for (const JerkStencil& s : jerkStencils(times))
    for (std::size_t j = 0; j < dof; ++j) {
      double jerk = 0.0;
      for (std::size_t k = 0; k < 4; ++k)
        if (s.last + k >= 3 && s.last + k - 3 < q.size())
          jerk += s.weight[k] * q[s.last + k - 3][static_cast<Eigen::Index>(j)];
      if (std::abs(jerk) > measure.maxAbs[j]) {
        measure.maxAbs[j] = std::abs(jerk);
        measure.maxAt[j] = std::min(std::max<std::size_t>(s.last, 2) - 1, q.size() - 1);
      }
      const double angle = j < limits.size() ? robot::asAngle(limits[j].kind, jerk) : jerk;
      measure.sumSquared += angle * angle;
    }
  return measure;
}

} // namespace voluta::motion
