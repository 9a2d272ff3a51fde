#include "robot/upright_axes.h"

#include "base/error.h"
#include "robot/angles.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRounding = 1e-9; // of a cosine

Vector3d turnedAboutX(const Vector3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z()};
}

double angleAboutX(const Vector3d& v) {
  return std::atan2(v.z(), v.y());
}

// base_R_first Rx(a) first_R_second Rx(b) second_R_work direction = z. The part of a vector along x
// is the same before and after the first rotation, which determines b up to its sign about the
// middle; a follows.
class Solver {
public:
  explicit Solver(const Cell& cell)
      : up_(cell.externalAxes()[0].before_T_axis.linear().transpose() * Vector3d::UnitZ()),
        between_(cell.externalAxes()[1].before_T_axis.linear()),
        behind_(cell.axis_T_work().linear()) {}

  std::vector<UprightAxes> of(const Vector3d& direction) const {
    Vector3d d = (behind_ * direction).normalized();
    std::vector<UprightAxes> found;
    if (std::hypot(d.y(), d.z()) < kAlongAxisRad) {
      d = Vector3d(std::copysign(1.0, d.x()), 0.0, 0.0);
      if (std::abs((between_ * d).x() - up_.x()) < kAlongAxisRad)
        found.push_back({bothAxes(d, 0.0), true});
      return found;
    }
    const Vector3d row = between_.row(0);
    const double cosine = row.y() * d.y() + row.z() * d.z();
    const double sine = row.z() * d.y() - row.y() * d.z();
    const double maximum = std::hypot(cosine, sine), wanted = up_.x() - row.x() * d.x();
    if (std::abs(wanted) > maximum + kRounding)
      return found;
    const double middle = std::atan2(sine, cosine);
    const double offset = maximum > 0.0 ? std::acos(std::clamp(wanted / maximum, -1.0, 1.0)) : 0.0;
    found.push_back({bothAxes(d, middle + offset), false});
    if (offset > 0.0)
      found.push_back({bothAxes(d, middle - offset), false});
    return found;
  }

private:
  JointVector bothAxes(const Vector3d& d, double second) const {
    JointVector axes(2);
    axes << wrappedAngle(angleAboutX(up_) - angleAboutX(between_ * turnedAboutX(d, second))),
        wrappedAngle(second);
    return axes;
  }

  Vector3d up_;
  Matrix3d between_, behind_;
};

} // namespace

bool tiltsPart(const Cell& cell) {
  const std::vector<ExternalAxis>& axes = cell.externalAxes();
  return !cell.robot().kinematics->tilts() && !cell.rod() && axes.size() == 2 &&
         std::all_of(axes.begin(), axes.end(), [](const ExternalAxis& axis) {
           return axis.limits.kind == JointKind::Turning && !axis.carriesRobot;
         });
}

std::vector<UprightAxes> uprightAxes(const Cell& cell, const Vector3d& direction) {
  base::require(tiltsPart(cell), "a cell that tilts the part");
  return Solver(cell).of(direction);
}

} // namespace voluta::robot
