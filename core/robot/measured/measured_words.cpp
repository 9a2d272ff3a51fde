#include "robot/measured/measured_words.h"

#include "base/units.h"
#include "geometry/turn_angles.h"

#include <cmath>

namespace voluta::robot {

namespace {

// Rounds to thousandths for display; avoids "-0.000".
Eigen::Vector3d written(const Eigen::Vector3d& v) {
  return v.unaryExpr([](double x) { return std::round(1000.0 * x) / 1000.0 + 0.0; });
}

} // namespace

base::Message placeOf(const Eigen::Isometry3d& frame) {
  const Eigen::Vector3d at = written(frame.translation());
  const Eigen::Vector3d rotation =
      written(base::radiansToDegrees(1.0) *
              geometry::anglesOf(Eigen::Quaterniond(frame.linear()), Eigen::Vector3d::Zero()));
  return base::message(
      "at {x:.3f#}, {y:.3f#}, {z:.3f}, rotated by {rx:.3f#}, {ry:.3f#}, {rz:.3f}"_text,
      base::mm(at.x()), base::mm(at.y()), base::mm(at.z()), base::degrees(rotation.x()),
      base::degrees(rotation.y()), base::degrees(rotation.z()));
}

base::Message agreementOf(const Residual& residual, std::size_t rows) {
  if (!residual.noiseMm || !residual.placeMm)
    return base::message("no redundant measurements: the error cannot be estimated"_text);
  const double rotation = base::radiansToDegrees(residual.angleRad.value_or(0.0));
  if (rotation == 0.0)
    return base::message(
        "{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f}"_text,
        rows, base::mm(residual.rmsMm), base::mm(residual.worstMm), base::mm(*residual.placeMm));
  return base::message(
      "{rows} rows, residual {rms:.3f} on average and {worst:.3f} at most: accurate to {place:.3f} and {turn:.3f}"_text,
      rows, base::mm(residual.rmsMm), base::mm(residual.worstMm), base::mm(*residual.placeMm),
      base::degrees(rotation));
}

} // namespace voluta::robot
