#include "robot/robot_model.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

std::vector<std::string> robotIds() {
  return base::dataFileIds("robots");
}

RobotModel loadRobot(const std::string& id) {
  return readRobot(base::dataFile("robots", id, "unknown robot '{id}'"_text));
}

std::vector<JointKind> kindsOf(const std::vector<JointLimits>& limits) {
  std::vector<JointKind> kinds;
  for (const JointLimits& limit : limits)
    kinds.push_back(limit.kind);
  return kinds;
}

JointVector asAngles(const JointVector& step, const std::vector<JointLimits>& limits) {
  const auto count = std::min(step.size(), static_cast<Eigen::Index>(limits.size()));
  JointVector turns = step.head(count);
  for (Eigen::Index i = 0; i < count; ++i)
    turns[i] = asAngle(limits[static_cast<std::size_t>(i)].kind, step[i]);
  return turns;
}

double largestRotation(const JointVector& step, const std::vector<JointLimits>& limits) {
  double largest = 0.0;
  const auto count = std::min(step.size(), static_cast<Eigen::Index>(limits.size()));
  for (Eigen::Index i = 0; i < count; ++i)
    largest =
        std::max(largest, std::abs(asAngle(limits[static_cast<std::size_t>(i)].kind, step[i])));
  return largest;
}

namespace {
constexpr double kSlack = 1e-9; // Do not reject a joint at its limit because of rounding
}

void inverseNear(const RobotModel& robot, const Eigen::Isometry3d& base_T_flange,
                 const JointVector& near, std::vector<JointVector>& solutions) {
  solutions.clear();
  robot.kinematics->inverse(base_T_flange, solutions);
  keepWithinLimits(robot, near, solutions);
}

std::optional<JointVector> nextBranch(const RobotModel& robot,
                                      const Eigen::Isometry3d& base_T_flange,
                                      const JointVector& near, double maxRad) {
  if (robot.kinematics->isFast())
    return std::nullopt;
  JointVector q = near.head(robot.dof());
  if (!robot.kinematics->solveNear(base_T_flange, q) ||
      largestRotation(q - near.head(robot.dof()), robot.limits) > maxRad)
    return std::nullopt;
  for (int i = 0; i < robot.dof(); ++i) {
    const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
    if (q[i] < limit.min - kSlack || q[i] > limit.max + kSlack)
      return std::nullopt;
    q[i] = std::clamp(q[i], limit.min, limit.max);
  }
  return q;
}

void keepWithinLimits(const RobotModel& robot, const JointVector& near,
                      std::vector<JointVector>& solutions) {
  base::require(near.size() >= robot.dof(), "inverseNear: fewer joints than the robot has");
  const auto outside = [&](JointVector& q) {
    for (int i = 0; i < robot.dof(); ++i) {
      const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
      if (limit.kind == JointKind::Sliding) {
        if (q[i] < limit.min - kSlack || q[i] > limit.max + kSlack)
          return true;
        q[i] = std::clamp(q[i], limit.min, limit.max);
        continue;
      }
      if (std::abs(near[i] - q[i]) < 0.99 * base::kPi && q[i] >= limit.min && q[i] <= limit.max)
        continue; // The usual case
      const double minimum = std::ceil((limit.min - kSlack - q[i]) / base::kTwoPi);
      const double maximum = std::floor((limit.max + kSlack - q[i]) / base::kTwoPi);
      if (minimum > maximum)
        return true;
      const double turns =
          std::clamp(std::round((near[i] - q[i]) / base::kTwoPi), minimum, maximum);
      q[i] = std::clamp(q[i] + base::kTwoPi * turns, limit.min, limit.max);
    }
    return false;
  };
  solutions.erase(std::remove_if(solutions.begin(), solutions.end(), outside), solutions.end());
}

} // namespace voluta::robot
