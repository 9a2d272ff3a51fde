#include "cells/cell_form.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voluta::cells {

namespace {

double headMm(const process::Process& process) {
  return process.head.sections.empty() ? 0.0 : process.head.sections.back().zMm;
}

} // namespace

double freeBelowPlateMm(const robot::Cell& cell) {
  std::vector<Eigen::Isometry3d> frames;
  cell.framePoses(cell.home(), frames);
  const double level = frames[static_cast<std::size_t>(cell.workFrame())].translation().z();
  double free = std::numeric_limits<double>::infinity();
  for (const robot::Body& body : cell.bodies()) {
    if (body.role != robot::BodyRole::Obstacle)
      continue;
    for (const robot::Shape& shape : body.shapes)
      if (const auto* box = std::get_if<robot::Box>(&shape)) {
        const Eigen::Isometry3d pose =
            frames[static_cast<std::size_t>(body.frame)] * box->frame_T_box;
        const double top =
            pose.translation().z() + pose.linear().row(2).cwiseAbs().dot(box->half.transpose());
        if (top <= level)
          free = std::min(free, level - top);
      }
  }
  return free;
}

CellForm formOf(const robot::Cell& cell, const process::Process& process) {
  if (cell.rod())
    return CellForm::Rod;
  if (cell.nozzleMount() == robot::Mount::World)
    return CellForm::FixedNozzle;
  if (std::ranges::any_of(cell.externalAxes(), [](const robot::ExternalAxis& axis) {
        return !axis.carriesRobot && axis.limits.kind == robot::JointKind::Turning;
      }))
    return CellForm::TiltingTable;
  return freeBelowPlateMm(cell) >= headMm(process) ? CellForm::RaisedPlate : CellForm::TableOnFloor;
}

const CellTraits& traitsOf(CellForm form) {
  static const std::array<CellTraits, 5> kTable = {{
      {"fixed nozzle"_text, false, true, true},
      {"tilting table"_text, false, true, true},
      {"raised plate"_text, true, true, false},
      {"table on the floor"_text, true, false, false},
      {"rod"_text, false, false, true},
  }};
  return kTable.at(static_cast<std::size_t>(form));
}

} // namespace voluta::cells
