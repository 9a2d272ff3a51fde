#include "replay/arm_speeds.h"

#include <cmath>
#include <cstddef>

namespace voluta::replay {

namespace {
constexpr double kSpeedSlack = 1.02; // tolerance for the rounding of speeds in a program's text
constexpr double kJumpRad = 1.0;
} // namespace

std::vector<LimitViolation> speedViolations(const ExecutedPath& path, const robot::Cell& cell) {
  std::vector<LimitViolation> violations;
  const auto dof = static_cast<std::size_t>(path.dof), arm = static_cast<std::size_t>(path.armDof);
  const auto stepOf = [&](std::size_t axis) {
    return axis < arm ? 0.0 : cell.externalAxes()[axis - arm].step;
  };
  for (std::size_t a = 1; a < path.armMotion.size(); ++a) {
    const std::size_t m = path.armMotion[a];
    if (m == 0)
      continue;
    const double from = path.armMotion[a - 1] == m ? path.armFraction[a - 1] : 0.0;
    const double time = (path.armFraction[a] - from) * path.durationS[m];
    const double* q0 = path.armJoints.data() + (a - 1) * dof;
    const double* q1 = path.armJoints.data() + a * dof;
    LimitViolation worst{LimitKind::JointSpeed, m, -1, 0.0, 0.0};
    double excess = kSpeedSlack;
    for (std::size_t k = 0; k < dof; ++k) {
      const double limit = cell.limits()[k].velocity;
      double angle = std::abs(q1[k] - q0[k]);
      const double jump = robot::fromAngle(path.kinds[k], kJumpRad);
      if (angle > jump) {
        worst = {LimitKind::BranchJump, m, static_cast<int>(k), angle, jump};
        break;
      }
      angle -= (path.armFraction[a] - from) * stepOf(k);
      if (angle < 1e-6 || time <= 0.0)
        continue;
      if (angle / time > excess * limit) {
        excess = angle / time / limit;
        worst.joint = static_cast<int>(k);
        worst.value = angle / time;
        worst.limit = limit;
      }
    }
    if (worst.joint >= 0 && (violations.empty() || violations.back().motion != m ||
                             violations.back().kind != worst.kind))
      violations.push_back(worst);
  }
  return violations;
}

} // namespace voluta::replay
