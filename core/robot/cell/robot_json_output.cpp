#include "robot/cell/robot_json_output.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::robot {

namespace {

using nlohmann::json;

void requireNumbers(const std::vector<double>& values, std::size_t count,
                    const std::string& option) {
  if (values.size() != count)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("{option}: {wanted} numbers expected, {given} given"_text,
                                    option, count, values.size()));
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("{option}: a value is not finite"_text, option));
}

double plainZero(double v) {
  return v == 0.0 ? 0.0 : v;
} // avoids "-0.0" in the text

} // namespace

std::string forwardJson(const RobotModel& robot, const std::vector<double>& shown) {
  requireNumbers(shown, static_cast<std::size_t>(robot.dof()), "--fk");
  JointVector q(robot.dof());
  for (int i = 0; i < robot.dof(); ++i)
    q[i] = ofShownValue(robot.kinematics->kindOf(i), shown[static_cast<std::size_t>(i)]);
  const Eigen::Isometry3d pose = robot.kinematics->flange(q);
  Eigen::Quaterniond r(pose.linear());
  if (r.w() < 0.0)
    r.coeffs() = -r.coeffs();
  const Eigen::Vector3d p = pose.translation();
  const json out = {
      {"positionMm", {plainZero(p.x()), plainZero(p.y()), plainZero(p.z())}},
      {"quaternion", {plainZero(r.w()), plainZero(r.x()), plainZero(r.y()), plainZero(r.z())}}};
  return out.dump();
}

std::string inverseJson(const RobotModel& robot, const std::vector<double>& pose) {
  requireNumbers(pose, 7, "--ik");
  const Eigen::Quaterniond r(pose[3], pose[4], pose[5], pose[6]);
  if (std::abs(r.norm() - 1.0) > 0.01)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("--ik: the quaternion's length is {length:.4g}, not 1"_text,
                                    base::number(r.norm())));
  Eigen::Isometry3d base_T_flange = Eigen::Isometry3d::Identity();
  base_T_flange.translation() = Eigen::Vector3d(pose[0], pose[1], pose[2]);
  base_T_flange.linear() = r.normalized().toRotationMatrix();
  std::vector<JointVector> solutions;
  inverseNear(robot, base_T_flange, JointVector::Zero(robot.dof()), solutions);
  json list = json::array();
  for (const JointVector& q : solutions) {
    json joints = json::array();
    for (int i = 0; i < robot.dof(); ++i)
      joints.push_back(plainZero(shownValue(robot.kinematics->kindOf(i), q[i])));
    list.push_back(std::move(joints));
  }
  return json{{"solutions", std::move(list)}}.dump();
}

} // namespace voluta::robot
