#include "program/gcode/table_of_cell.h"

#include "robot/upright_axes.h"

#include <cmath>

namespace voluta::program {

namespace {
constexpr double kSame = 1e-6; // of a unit vector, or mm
}

std::optional<CellTable> tableOf(const robot::Cell& cell) {
  if (!robot::tiltsPart(cell))
    return std::nullopt;
  const Eigen::Isometry3d& base_T_work = cell.base_T_fixed();
  const robot::ExternalAxis &tilt = cell.externalAxes()[0], &rotation = cell.externalAxes()[1];
  const Eigen::Isometry3d rotationAtZero = tilt.before_T_axis * rotation.before_T_axis;
  const Eigen::Vector3d tiltAxis = tilt.before_T_axis.linear().col(0),
                        rotationAxis = rotationAtZero.linear().col(0),
                        plate = base_T_work.translation() - tilt.before_T_axis.translation(),
                        offset = base_T_work.translation() - rotationAtZero.translation();
  if (!base_T_work.linear().isIdentity(kSame) || std::abs(std::abs(tiltAxis.y()) - 1.0) > kSame ||
      std::abs(std::abs(rotationAxis.z()) - 1.0) > kSame || offset.head<2>().norm() > kSame)
    return std::nullopt;
  return CellTable{{plate.x(), plate.z()}, tiltAxis.y(), rotationAxis.z()};
}

} // namespace voluta::program
