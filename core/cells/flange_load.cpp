#include "cells/flange_load.h"

#include "robot/payload_curve.h"

namespace voluta::cells {

FlangeLoad flangeLoad(const robot::Cell& cell, const process::Process& process, double onPlateKg,
                      double centreMm) {
  FlangeLoad load;
  Eigen::Vector3d centre;
  if (cell.nozzleMount() == robot::Mount::World) {
    load.kg = cell.carriedKg() + onPlateKg;
    const double share = load.kg > 0.0 ? onPlateKg / load.kg : 0.0;
    centre = cell.flange_T_moved() * Eigen::Vector3d(0, 0, share * centreMm);
  } else {
    load.kg = cell.carriedKg();
    const auto& sections = process.head.sections;
    const double head = sections.empty() ? 0.0 : sections.back().zMm;
    centre = cell.flange_T_moved() * Eigen::Vector3d(0, 0, -0.5 * head);
  }
  load.leverMm = centre.norm();
  if (const auto maximum = robot::payloadAt(cell.robot(), load.leverMm)) {
    load.maxKg = maximum->kg;
    load.byCurve = maximum->byCurve;
  }
  return load;
}

} // namespace voluta::cells
