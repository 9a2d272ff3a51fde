#include "motion/ladder/joint_costs.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using robot::JointVector;

namespace {
constexpr double kLimitCost = 0.5;      // Cost of a joint at its limit
constexpr double kRevolutionCost = 0.3; // Cost of unwinding a joint by a whole turn
constexpr double kBranchStep = 1.0;     // [rad]: a larger step of a joint means another IK branch
constexpr double kBranchCost = 4.0;     // Cost per rad beyond kBranchStep
} // namespace

double limitCost(const JointVector& q, const std::vector<robot::JointLimits>& limits) {
  double cost = 0.0;
  for (std::size_t j = 0; j < limits.size(); ++j) {
    const auto& l = limits[j];
    const double middle = 0.5 * (l.min + l.max), half = 0.5 * (l.max - l.min);
    const double beyond =
        std::max(0.0, std::abs(q[static_cast<Eigen::Index>(j)] - middle) / half - 0.8) / 0.2;
    cost += kLimitCost * beyond * beyond;
  }
  return cost;
}

double startCost(const JointVector& from, const JointVector& to,
                 const std::vector<robot::JointLimits>& limits) {
  double cost = 0.0, largest = 0.0;
  const JointVector step = robot::asAngles(to - from, limits);
  for (Eigen::Index j = 0; j < step.size(); ++j) {
    const bool slides = limits[static_cast<std::size_t>(j)].kind == robot::JointKind::Sliding;
    const double turns = slides ? 0.0 : std::round(step[j] / base::kTwoPi);
    const double rest = std::abs(step[j] - base::kTwoPi * turns);
    cost += rest + kRevolutionCost * std::abs(turns);
    largest = std::max(largest, rest);
  }
  return cost + kBranchCost * std::max(0.0, largest - kBranchStep);
}

} // namespace voluta::motion
