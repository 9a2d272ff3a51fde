#include "robot/cell/json_output.h"

#include "base/error.h"
#include "base/units.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace voluta::robot {

using Json = nlohmann::ordered_json;

Json degreesJson(double rad) {
  return tidy(base::radiansToDegrees(rad));
}

Json shapeJson(const Shape& shape) {
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return {{"capsule",
             {{"p0Mm", vectorJson(capsule->p0)},
              {"p1Mm", vectorJson(capsule->p1)},
              {"radiusMm", tidy(capsule->radius)}}}};
  if (const auto* box = std::get_if<Box>(&shape))
    return {
        {"box", {{"pose", poseJson(box->frame_T_box)}, {"sizeMm", vectorJson(2.0 * box->half)}}}};
  const auto* frustum = std::get_if<Frustum>(&shape);
  base::require(frustum != nullptr, "a shape that files can hold");
  return {{"frustum",
           {{"p0Mm", vectorJson(frustum->p0)},
            {"p1Mm", vectorJson(frustum->p1)},
            {"r0Mm", tidy(frustum->r0)},
            {"r1Mm", tidy(frustum->r1)}}}};
}

double tidy(double value) {
  const double rounded = std::round(value * 1e9) / 1e9;
  return std::abs(value - rounded) < 1e-13 * std::max(1.0, std::abs(value)) ? rounded + 0.0 : value;
}

Json vectorJson(const Eigen::Vector3d& v) {
  return {tidy(v.x()), tidy(v.y()), tidy(v.z())};
}

// The last angle is computed from the other two, so that no precision is lost at a right middle
// angle.
Json poseJson(const Eigen::Isometry3d& pose) {
  const auto& r = pose.linear();
  const double yaw = std::atan2(r(1, 0), r(0, 0));
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double pitch = std::atan2(-r(2, 0), c * r(0, 0) + s * r(1, 0));
  const double roll = std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
  return {{"xyzMm", vectorJson(pose.translation())},
          {"rpyDeg", {degreesJson(roll), degreesJson(pitch), degreesJson(yaw)}}};
}

Json shapesJson(const std::vector<Shape>& shapes) {
  Json list = Json::array();
  for (const Shape& shape : shapes)
    list.push_back(shapeJson(shape));
  return list;
}

} // namespace voluta::robot
