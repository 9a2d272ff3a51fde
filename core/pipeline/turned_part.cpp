#include "pipeline/turned_part.h"
#include "modes/plate.h"

#include "base/stopwatch.h"
#include "base/units.h"
#include "pipeline/choices.h"
#include "placement/orient.h"
#include "plan/finding_kinds.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

constexpr double kSame = 1e-6; // rad
constexpr std::string_view kFewestMissed = "fewestMissed";

plan::Finding findingOf(const placement::Orientation& found, bool fewestMissed, bool turned) {
  using plan::FindingKind;
  if (!turned)
    return plan::makeFinding(FindingKind::NotTurned, {{"ways", found.tried}}, std::nullopt,
                             found.tried);
  const Eigen::AngleAxisd by(found.turn);
  const auto clean = [](double x) { return base::number(std::round(100.0 * x) / 100.0 + 0.0); };
  std::vector<plan::NamedValue> values{{"angle", base::degrees(base::radiansToDegrees(by.angle()))},
                                       {"x", clean(by.axis().x())},
                                       {"y", clean(by.axis().y())},
                                       {"z", clean(by.axis().z())},
                                       {"overhang", base::mm2(found.score.riskyMm2)},
                                       {"overhangBefore", base::mm2(found.before.riskyMm2)}};
  if (fewestMissed) {
    values.push_back({"missed", found.missed});
    values.push_back({"voxel", base::mm(found.searchMm)});
    values.push_back({"missedBefore", found.missedBefore});
  }
  return plan::makeFinding(fewestMissed ? FindingKind::TurnedFewestMissed
                                        : FindingKind::TurnedLeastRisky,
                           std::move(values), std::nullopt, found.tried);
}

} // namespace

TurnPlan turnPlan(const project::Choices& choices, const base::ParameterValues& values) {
  const std::string objective = values.text("orient");
  if (objective == "none")
    return {objective, 0.0, 0.0, {}};
  return {objective, values.number("voxelMm"),
          base::degreesToRadians(values.number("overhangAngle")),
          objective == kFewestMissed ? choices.item().platform : project::Platform()};
}

TurnedPart turnedPart(const geometry::TriangleMesh& placed, const geometry::Placement& placement,
                      const TurnPlan& plan, double voxelMm, bool onlyQuarters,
                      const base::RunContext& ctx) {
  TurnedPart out;
  out.placement = placement;
  if (plan.objective == "none")
    return out;
  const base::Stopwatch clock;
  const bool fewestMissed = plan.objective == kFewestMissed;
  placement::OrientOptions options;
  options.voxelMm = voxelMm;
  options.overhangRad = plan.overhangRad;
  options.quarterTurns = onlyQuarters;
  options.centreMm = placement.centreMm;
  options.platform = [&](const voxel::SolidVoxels& part) {
    return modes::plateOf(plan.platform, part);
  };
  const placement::Orientation found = placement::bestOrientation(
      placed, fewestMissed ? placement::Objective::FewestMissed : placement::Objective::LeastRisky,
      options, ctx);
  const bool turned = found.turn.angularDistance(Eigen::Quaterniond::Identity()) > kSame;
  if (turned)
    out.placement.rotation = (found.turn * placement.rotation.normalized()).normalized();
  out.findings.push_back(findingOf(found, fewestMissed, turned));
  out.seconds = clock.seconds();
  return out;
}

} // namespace voluta::pipeline
