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

void inverseNear(const RobotModel& robot, const Eigen::Isometry3d& base_T_flange,
                 const JointVector& near, std::vector<JointVector>& solutions) {
  // A joint at its limit must not be lost to rounding.
  constexpr double kSlack = 1e-9;
  base::require(near.size() >= robot.dof(), "inverseNear: fewer joints than the robot has");

  solutions.clear();
  robot.kinematics->inverse(base_T_flange, solutions);
  const auto outside = [&](JointVector& q) {
    for (int i = 0; i < robot.dof(); ++i) {
      const JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
      const double least = std::ceil((limit.min - kSlack - q[i]) / base::kTurn);
      const double most = std::floor((limit.max + kSlack - q[i]) / base::kTurn);
      if (least > most)
        return true;
      const double turns = std::clamp(std::round((near[i] - q[i]) / base::kTurn), least, most);
      q[i] = std::clamp(q[i] + base::kTurn * turns, limit.min, limit.max);
    }
    return false;
  };
  solutions.erase(std::remove_if(solutions.begin(), solutions.end(), outside), solutions.end());
}

} // namespace voluta::robot
