#include "pipeline/cell_reach.h"

#include "base/key_text.h"
#include "curved/platform_polygon.h"
#include "geometry/measures.h"
#include "modes/cell_choice.h"
#include "motion/motion_options.h"
#include "pipeline/cell_text.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

std::vector<Eigen::Vector2d> plateToMap(const project::Choices& choices, const robot::Cell& cell) {
  const project::Platform& platform = choices.item().platform;
  if (platform.isFor(project::PlatformUse::Plate) && !platform.isOfCell() && !platform.marginMm() &&
      !platform.isBody())
    return platform.plateAround({});
  return cell.plates().empty() ? curved::platformDisc(kPlateOfNoneMm)
                               : project::Platform(cell.plates().back()).plateAround({});
}

} // namespace

robot::Cell cellToMap(const project::Choices& choices, const process::Process& process) {
  const robot::Cell any = modes::cellOnAnyPlatform(choices, process);
  if (any.rod())
    return any;
  return robot::loadCell(choices.cell, process, plateToMap(choices, any));
}

cells::ReachMap cellReach(const Resolved& resolved, double heightMm, const base::RunContext& ctx) {
  const auto& [choices, values, process] = resolved.modeChoices();
  const robot::Cell cell = cellToMap(choices, process);
  return cells::reachMap(cell, process, cells::usualGrid(cell, process, heightMm),
                         motionOptionsOf(values, choices.seed).printing, ctx);
}

std::string cellReachKey(const Resolved& resolved, double heightMm) {
  const auto& [choices, values, process] = resolved.modeChoices();
  const robot::Cell cell = modes::cellOnAnyPlatform(choices, process);
  const collision::Margins margins = motionOptionsOf(values, choices.seed).printing;
  std::vector<double> plate, head;
  if (!cell.rod())
    for (const Eigen::Vector2d& corner : plateToMap(choices, cell))
      plate.insert(plate.end(), {corner.x(), corner.y()});
  for (const process::HeadSection& section : process.head.sections)
    head.insert(head.end(), {section.zMm, section.radiusMm});
  return base::keyText(cellText(cell, choices.cell), plate, head, process.layerHeightMm,
                       process.contactToleranceMm, margins.bodiesMm, margins.partMm, margins.headMm,
                       heightMm);
}

Eigen::Vector2d middleOf(const geometry::TriangleMesh& part) {
  return geometry::bounds(part).center().head<2>();
}

cells::Standing standingOf(const geometry::TriangleMesh& part) {
  const Eigen::Vector2d middle = middleOf(part);
  cells::Standing standing;
  for (const Eigen::Vector3d& v : part.vertices) {
    standing.radiusMm = std::max(standing.radiusMm, (v.head<2>() - middle).norm());
    standing.heightMm = std::max(standing.heightMm, v.z());
  }
  constexpr double kMinMm = 1e-3; // A point needs a size too
  standing.radiusMm = std::max(standing.radiusMm, kMinMm);
  standing.heightMm = std::max(standing.heightMm, kMinMm);
  standing.tiltRad = kMappedTiltRad;
  return standing;
}

} // namespace voluta::pipeline
