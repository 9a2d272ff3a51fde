#include "project/turn_text.h"

#include "base/error.h"
#include "base/number_list.h"
#include "base/units.h"
#include "geometry/turn_angles.h"

#include <fmt/format.h>

namespace voluta::project {

Eigen::Vector3d rotationDegrees(const Eigen::Quaterniond& rotation) {
  constexpr double kSteps = 1000.0; // steps per degree
  const Eigen::Vector3d angles = geometry::anglesOf(rotation, Eigen::Vector3d::Zero());
  // + 0.0 turns -0 into 0.
  return (kSteps * angles.unaryExpr(&base::radiansToDegrees)).array().round() / kSteps + 0.0;
}

Eigen::Quaterniond rotationOfDegrees(const Eigen::Vector3d& degrees) {
  return geometry::rotationOf(degrees.unaryExpr(&base::degreesToRadians));
}

std::string rotationText(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d degrees = rotationDegrees(rotation);
  return fmt::format("{:g},{:g},{:g}", degrees.x(), degrees.y(), degrees.z());
}

Eigen::Quaterniond parsedRotation(const std::string& text) {
  Eigen::Vector3d degrees;
  if (!base::readNumbers(text, ',', {&degrees.x(), &degrees.y(), &degrees.z()}))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("turn '{turn}' is not three angles"_text, text), {},
                      "give degrees about x, y and z: 90,0,0"_text);
  return rotationOfDegrees(degrees);
}

} // namespace voluta::project
