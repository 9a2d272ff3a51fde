#include "pipeline/part_ways.h"

#include "base/key_text.h"
#include "base/units.h"
#include "modes/mode_table.h"
#include "pipeline/open_part.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "project/turn_text.h"
#include "toolpath/options.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

placement::WaysOptions waysOptions(const modes::LoadStage& placed, const Resolved& resolved) {
  placement::WaysOptions options;
  options.layerHeightMm = resolved.process().layerHeightMm;
  options.overhangRad = base::degreesToRadians(resolved.values.number("overhangAngle"));
  options.quarterTurns = placed.voxels != nullptr;
  return options;
}

plan::Finding findingOf(const placement::BetterOrientation& found,
                        const geometry::Placement& placed) {
  const Eigen::Vector3d degrees = project::rotationDegrees(standing(found.best, placed).rotation);
  const auto share = [](const placement::StandingOrientation& orientation) {
    return base::percent(100.0 * orientation.missedShare());
  };
  return plan::makeFinding(plan::FindingKind::LiesBadly,
                           {{"contact", base::mm2(found.now.score.contactMm2)},
                            {"overhang", base::mm2(found.now.score.riskyMm2)},
                            {"missed", share(found.now)},
                            {"bestContact", base::mm2(found.best.score.contactMm2)},
                            {"bestOverhang", base::mm2(found.best.score.riskyMm2)},
                            {"bestMissed", share(found.best)},
                            {"x", base::degrees(degrees.x())},
                            {"y", base::degrees(degrees.y())},
                            {"z", base::degrees(degrees.z())}});
}

bool isOrientedByUser(const Resolved& resolved) {
  return standsFreely(resolved.choices) && resolved.values.text("orient") == "none";
}

} // namespace

bool standsFreely(const project::Choices& choices) {
  return !modes::findMode(choices.item().mode).place;
}

std::vector<placement::StandingOrientation>
partWays(const modes::LoadStage& placed, const Resolved& resolved, const base::RunContext& ctx) {
  return placement::waysToStand(*placed.part, waysOptions(placed, resolved), ctx);
}

double estimatedSeconds(const placement::StandingOrientation& orientation,
                        const Resolved& resolved) {
  const process::Process& process = resolved.process();
  const toolpath::ToolpathOptions options = toolpathOptionsOf(resolved.values, process);
  // A spiral counts its bottom in layers only.
  const double minMm = options.spiral ? 0.0 : options.skinMm;
  const auto skinMm = [&](int layers) { return std::max(minMm, layers * process.layerHeightMm); };
  placement::Filling filling;
  filling.walls = options.walls;
  filling.density = options.infillDensity;
  filling.topMm = skinMm(options.topLayers);
  filling.bottomMm = skinMm(options.bottomLayers);
  filling.spiral = options.spiral;
  filling.minLayerS = options.cooling.minLayerTimeS;
  return placement::estimatedSeconds(orientation.part, filling, process);
}

std::string partWaysKey(const project::LoadedPart& loaded, double scale, const Resolved& resolved) {
  const auto& [choices, values, process] = resolved.modeChoices();
  return base::keyText(loaded.hash, choices.item().repair, scale * unitMm(loaded, choices),
                       values.number("overhangAngle"), process.layerHeightMm) +
         openSurfacesKey(choices, values, process);
}

geometry::Placement standing(const placement::StandingOrientation& orientation,
                             const geometry::Placement& placed) {
  geometry::Placement out = placed;
  out.rotation = (orientation.rotation * placed.rotation.normalized()).normalized();
  out.liftMm = 0.0;
  return out;
}

std::string standKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                     const Resolved& resolved) {
  return partWaysKey(loaded, placed.scale, resolved) +
         base::keyText(placed.placement.rotation.coeffs(), isOrientedByUser(resolved));
}

std::shared_ptr<const StandStage>
standStage(const modes::LoadStage& placed, const Resolved& resolved, const base::RunContext& ctx) {
  auto stage = std::make_shared<StandStage>();
  if (!isOrientedByUser(resolved))
    return stage;
  if (const auto better =
          placement::betterOrientation(*placed.part, waysOptions(placed, resolved), ctx))
    stage->findings.push_back(findingOf(*better, placed.placement));
  return stage;
}

} // namespace voluta::pipeline
