#include "motion/joint_margins.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "geometry/symmetric_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::motion {

namespace {

using robot::JointVector;

constexpr std::size_t kChunk = 256;

JointVector jointsAt(const plan::Trajectory& t, std::size_t point) {
  return Eigen::Map<const JointVector>(t.at(point), t.dof);
}

std::vector<SpeedUse> speedsOf(const plan::Trajectory& t, const robot::Cell& cell) {
  constexpr double kMinS = 1e-6; // Shorter steps give no meaningful speed
  std::vector<SpeedUse> speeds(static_cast<std::size_t>(t.dof));
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    const double step = t.timeS[i] - t.timeS[i - 1];
    if (step < kMinS)
      continue;
    for (int j = 0; j < t.dof; ++j) {
      const double limit = cell.limits()[static_cast<std::size_t>(j)].velocity;
      const double share = std::abs(t.at(i)[j] - t.at(i - 1)[j]) / step / limit;
      if (SpeedUse& use = speeds[static_cast<std::size_t>(j)]; share > use.share)
        use = {share, i};
    }
  }
  return speeds;
}

} // namespace

double reachOf(const robot::RobotModel& robot) {
  std::vector<Eigen::Isometry3d> links;
  robot.kinematics->linkPoses(JointVector::Zero(robot.dof()), links);
  double reach = 0.0;
  for (std::size_t i = 1; i < links.size(); ++i)
    reach += (links[i].translation() - links[i - 1].translation()).norm();
  return std::max(reach, 1.0);
}

double isotropyAt(const robot::RobotModel& robot, const JointVector& q, double reachMm) {
  constexpr double kStep = 1e-5; // Step of the central differences: rad, or a share of the reach
  const int dof = robot.dof();
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 8> jacobian(6, dof);
  for (int j = 0; j < dof; ++j) {
    JointVector less = q.head(dof), more = less;
    const bool slides = robot.kinematics->kindOf(j) == robot::JointKind::Sliding;
    const double step = slides ? kStep * reachMm : kStep;
    less[j] -= step;
    more[j] += step;
    const Eigen::Isometry3d a = robot.kinematics->flange(less), b = robot.kinematics->flange(more);
    jacobian.col(j).head<3>() = (b.translation() - a.translation()) / (2.0 * kStep * reachMm);
    // For such a small rotation the skew part of the matrix is the rotation vector.
    const Eigen::Matrix3d rotation = b.linear() * a.linear().transpose();
    jacobian.col(j).tail<3>() =
        Eigen::Vector3d(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                        rotation(1, 0) - rotation(0, 1)) /
        (4.0 * kStep);
  }
  // Singular values are the square roots of the eigenvalues of the smaller of J J' and J' J,
  // ascending.
  using geometry::UpTo6x6;
  const geometry::UpTo6 values =
      geometry::symmetricValues(dof < 6 ? UpTo6x6(jacobian.transpose() * jacobian)
                                        : UpTo6x6(jacobian * jacobian.transpose()));
  const double maximum = values[values.size() - 1];
  return maximum > 0.0 ? std::sqrt(std::max(0.0, values[0]) / maximum) : 0.0;
}

MotionMargins marginsOf(const plan::Trajectory& t, const robot::Cell& cell,
                        const base::RunContext& ctx) {
  base::require(t.dof == cell.dof(), "the trajectory is the cell's");
  const std::size_t n = t.pointCount();
  MotionMargins margins;
  margins.joints.assign(static_cast<std::size_t>(t.dof),
                        {std::numeric_limits<double>::infinity(), 0});
  for (std::size_t i = 0; i < n; ++i)
    for (int j = 0; j < t.dof; ++j) {
      const robot::JointLimits& limits = cell.limits()[static_cast<std::size_t>(j)];
      const double rad = std::min(t.at(i)[j] - limits.min, limits.max - t.at(i)[j]);
      LimitMargin& margin = margins.joints[static_cast<std::size_t>(j)];
      if (rad < margin.rad)
        margin = {rad, i};
    }
  margins.speeds = speedsOf(t, cell);
  const double reach = reachOf(cell.robot());
  std::vector<double> isotropy(n, 1.0);
  base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i)
      isotropy[i] = isotropyAt(cell.robot(), jointsAt(t, i), reach);
  });
  const auto minimum = std::min_element(isotropy.begin(), isotropy.end());
  if (minimum != isotropy.end()) {
    margins.isotropy = *minimum;
    margins.isotropyPoint = static_cast<std::size_t>(minimum - isotropy.begin());
  }
  return margins;
}

} // namespace voluta::motion
