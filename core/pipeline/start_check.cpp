#include "pipeline/start_check.h"

#include "base/key_text.h"
#include "cells/cell_check.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "modes/mode_table.h"
#include "motion/motion_options.h"
#include "pipeline/cell_plate.h"
#include "pipeline/cell_reach.h"
#include "pipeline/part_size.h"
#include "pipeline/pedestal.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;
using Polygon = std::vector<Vector2d>;

constexpr double kMinMm = 3.0; // margin around a footprint that is a point or a line

Eigen::AlignedBox2d boxOf(const Polygon& polygon) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : polygon)
    box.extend(corner);
  return box;
}

// Returns the largest scale at which the footprint, centred on the plate, is within the plate.
double shareWithin(const Polygon& foot, const Polygon& plate) {
  const Vector2d footMiddle = boxOf(foot).center(), plateMiddle = boxOf(plate).center();
  double scale = INFINITY;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    const Vector2d side = plate[(i + 1) % plate.size()] - plate[i];
    const Vector2d outwards = Vector2d(side.y(), -side.x()).normalized();
    double reach = 0.0;
    for (const Vector2d& corner : foot)
      reach = std::max(reach, outwards.dot(corner - footMiddle));
    if (reach > 0.0)
      scale = std::min(scale, outwards.dot(plate[i] - plateMiddle) / reach);
  }
  return scale;
}

Polygon quarterTurned(Polygon polygon) {
  for (Vector2d& corner : polygon)
    corner = Vector2d(-corner.y(), corner.x());
  return polygon;
}

// Mode auto does not get around a plate that is too small by making a platform: the user has to
// choose a larger platform explicitly.
bool isForCellPlates(const project::Choices& choices) {
  return choices.item().platform.isOfCell() ||
         (choices.item().automatic && !choices.item().platformStays);
}

// Returns the plate's outline; empty if the part is on no plate.
Polygon plateUnder(const modes::LoadStage& placed, const project::Choices& choices,
                   const Polygon& foot) {
  const project::Platform& platform = choices.item().platform;
  if (modes::findMode(choices.item().mode).aroundRod || platform.isBody() ||
      !platform.isFor(project::PlatformUse::Plate))
    return {};
  if (platform.isOfCell())
    return placed.platform;
  if (const std::optional<double> margin = platform.marginMm())
    return geometry::convexPolygon(foot, std::max(*margin, kMinMm));
  return platform.plateAround({});
}

std::optional<plan::Finding> largerThanPlates(const Polygon& foot, const robot::Cell& cell,
                                              double scaleNow) {
  const Polygon plate = largestPlate(cell);
  if (plate.empty())
    return std::nullopt;
  const double fits = std::max(shareWithin(foot, plate), shareWithin(quarterTurned(foot), plate));
  if (fits >= 1.0)
    return std::nullopt;
  // For the present orientation, so that the user need not turn the part.
  const double scale = scaleWithin(scaleNow * shareWithin(foot, plate));
  const Vector2d size = boxOf(foot).sizes();
  return plan::makeFinding(plan::FindingKind::LargerThanPlates,
                           {{"length", base::mm(size.maxCoeff())},
                            {"width", base::mm(size.minCoeff())},
                            {"plate", project::Platform(cell.plates().back()).shown()},
                            {"scale", base::number(scale)}});
}

} // namespace

std::string startKey(const modes::LoadStage& placed, const project::Choices& given,
                     const Resolved& resolved) {
  const Polygon foot = footOf(*placed.part);
  const Eigen::AlignedBox3d box = geometry::bounds(*placed.part);
  return base::keyText(isForCellPlates(given), placed.scale, foot, plateUnder(placed, given, foot),
                       Vector2d(box.min().head<2>()), Vector2d(box.max().head<2>())) +
         cellReachKey(resolved, resolved.process().layerHeightMm);
}

std::shared_ptr<const StartStage> startStage(const modes::LoadStage& placed,
                                             const project::Choices& given,
                                             const Resolved& resolved,
                                             const base::RunContext& ctx) {
  auto stage = std::make_shared<StartStage>();
  const Polygon foot = footOf(*placed.part);
  const Polygon plate = plateUnder(placed, given, foot);
  const process::Process& process = resolved.process();
  if (plate.empty())
    return stage;
  const robot::Cell cell = robot::loadCell(given.cell, process, plate);
  if (cell.rod())
    return stage; // Reported where a plate is needed there.
  if (adriftMm(given.item().platform, *placed.part, cell) > 0.0)
    return stage; // Reported where the platform is made; the cell is not at fault.
  const collision::Margins margins = motionOptionsOf(resolved.values, given.seed).printing;
  for (const cells::CellFault& fault : cells::printingFaults(cell, process, margins, ctx))
    stage->findings.push_back(plan::makeFinding(plan::FindingKind::CellCannotPrint,
                                                {{"fault", fault.what}, {"help", fault.remedy}}));
  if (isForCellPlates(given))
    if (auto larger = largerThanPlates(foot, cell, placed.scale))
      stage->findings.push_back(std::move(*larger));
  return stage;
}

} // namespace voluta::pipeline
