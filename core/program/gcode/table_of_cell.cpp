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
  const robot::ExternalAxis &tilt = cell.externalAxes()[0], &turn = cell.externalAxes()[1];
  const Eigen::Isometry3d turnAtZero = tilt.before_T_axis * turn.before_T_axis;
  const Eigen::Vector3d tiltAxis = tilt.before_T_axis.linear().col(0),
                        turnAxis = turnAtZero.linear().col(0),
                        plate = base_T_work.translation() - tilt.before_T_axis.translation(),
                        aside = base_T_work.translation() - turnAtZero.translation();
  if (!base_T_work.linear().isIdentity(kSame) || std::abs(std::abs(tiltAxis.y()) - 1.0) > kSame ||
      std::abs(std::abs(turnAxis.z()) - 1.0) > kSame || aside.head<2>().norm() > kSame)
    return std::nullopt;
  return CellTable{{plate.x(), plate.z()}, tiltAxis.y(), turnAxis.z()};
}

} // namespace voluta::program
