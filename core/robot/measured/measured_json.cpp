#include "robot/measured/measured_json.h"

#include "base/error.h"
#include "base/units.h"
#include "robot/cell/json_output.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace voluta::robot {

namespace {

using Json = nlohmann::ordered_json;

base::Error unusable(const base::Message& what, const base::Message& remedy = {}) {
  return {base::ErrorCode::UnusableInput, what, {}, remedy};
}

Eigen::Vector3d vectorAt(const std::vector<double>& row, std::size_t from) {
  return {row[from], row[from + 1], row[from + 2]};
}

Json known(const std::optional<double>& value) {
  return value ? Json(tidy(*value)) : Json();
}

void addResidual(Json& out, const Residual& residual) {
  out["rmsMm"] = tidy(residual.rmsMm);
  out["worstMm"] = tidy(residual.worstMm);
  out["noiseMm"] = known(residual.noiseMm);
  out["placeMm"] = known(residual.placeMm);
}

Eigen::Isometry3d flangeOf(const std::vector<double>& row, const RobotModel* robot) {
  if (robot) {
    JointVector q(robot->dof());
    for (int i = 0; i < robot->dof(); ++i)
      q[i] = ofShownValue(robot->kinematics->kindOf(i), row[static_cast<std::size_t>(i)]);
    return robot->kinematics->flange(q);
  }
  const Eigen::Quaterniond rotation(row[3], row[4], row[5], row[6]);
  if (std::abs(rotation.norm() - 1.0) > 0.01)
    throw unusable(base::message("a quaternion's length is {length:.4g}, not 1"_text,
                                 base::number(rotation.norm())));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = vectorAt(row, 0);
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

} // namespace

MeasuredFrame frameOfRows(const NumberRows& rows) {
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  if (width == 3 && rows.size() == 3)
    return {frameFromPoints(vectorAt(rows[0], 0), vectorAt(rows[1], 0), vectorAt(rows[2], 0)), {}};
  if (width != 6)
    throw unusable(
        "not a table of points"_text,
        "give three rows x,y,z (origin, point on x, point in the xy plane), or at least three rows of six: nominal point in the frame, touched point"_text);
  std::vector<TouchedPoint> points;
  for (const std::vector<double>& row : rows)
    points.push_back({vectorAt(row, 0), vectorAt(row, 3)});
  return frameFromPoints(points);
}

MeasuredTip tipOfRows(const NumberRows& rows, const RobotModel* robot) {
  const std::size_t wanted = robot ? static_cast<std::size_t>(robot->dof()) : 7;
  std::vector<Eigen::Isometry3d> poses;
  for (const std::vector<double>& row : rows) {
    if (row.size() != wanted)
      throw unusable(
          base::message("{found} numbers in a row instead of {wanted}"_text, row.size(), wanted),
          robot
              ? base::Message("a row contains the robot's joints"_text)
              : base::Message("a row contains x,y,z,qw,qx,qy,qz; for joints name the robot"_text));
    poses.push_back(flangeOf(row, robot));
  }
  return toolTip(poses);
}

std::string frameJson(const MeasuredFrame& measured, std::size_t points) {
  Json out{{"pose", poseJson(measured.base_T_frame)}, {"points", points}};
  addResidual(out, measured.residual);
  const std::optional<double>& rotation = measured.residual.angleRad;
  out["turnDeg"] = rotation ? degreesJson(*rotation) : Json();
  return out.dump();
}

std::string tipJson(const MeasuredTip& measured, std::size_t poses) {
  Json out{{"tipMm", vectorJson(measured.tipInFlange)},
           {"pointMm", vectorJson(measured.pointInBase)},
           {"poses", poses}};
  addResidual(out, measured.residual);
  return out.dump();
}

} // namespace voluta::robot
