#include "pipeline/turned_part.h"
#include "base/error.h"
#include "modes/growth_plate.h"

#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/simplify.h"
#include "pipeline/stage_options.h"
#include "placement/orient.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace voluta::pipeline {

namespace {

constexpr double kSame = 1e-6; // rad

// Of a value of the parameter orient.
struct ObjectiveRow {
  std::string_view name;
  placement::Objective objective;
  plan::FindingKind turned;
};

const ObjectiveRow& objectiveNamed(std::string_view name) {
  using placement::Objective;
  using plan::FindingKind;
  static constexpr std::array<ObjectiveRow, 5> kRows{
      {{"leastRisky", Objective::MinRiskyArea, FindingKind::TurnedMinRiskyArea},
       {"fewestMissed", Objective::FewestMissed, FindingKind::TurnedFewestMissed},
       {"leastResidual", Objective::MinResidualArea, FindingKind::TurnedMinResidualArea},
       {"leastAfterCuts", Objective::MinAfterCuts, FindingKind::TurnedMinAfterCuts},
       {"leastTension", Objective::LeastTension, FindingKind::TurnedLeastTension}}};
  const auto row = std::find_if(kRows.begin(), kRows.end(),
                                [&](const ObjectiveRow& r) { return r.name == name; });
  base::require(row != kRows.end(), "objectiveNamed: a value of orient");
  return *row;
}

plan::Finding findingOf(const placement::Orientation& found, const ObjectiveRow& row, bool turned) {
  using placement::Objective;
  using plan::FindingKind;
  if (!turned)
    return plan::makeFinding(FindingKind::NotTurned, {{"ways", found.tried}}, std::nullopt,
                             found.tried);
  const Eigen::AngleAxisd by(found.rotation);
  const auto clean = [](double x) { return base::number(std::round(100.0 * x) / 100.0 + 0.0); };
  std::vector<plan::NamedValue> values{{"angle", base::degrees(base::radiansToDegrees(by.angle()))},
                                       {"x", clean(by.axis().x())},
                                       {"y", clean(by.axis().y())},
                                       {"z", clean(by.axis().z())},
                                       {"overhang", base::mm2(found.score.riskyMm2)},
                                       {"overhangBefore", base::mm2(found.before.riskyMm2)}};
  if (row.objective == Objective::MinResidualArea) {
    values.push_back({"xy", base::mm2(found.residual.xyMm2)});
    values.push_back({"xyBefore", base::mm2(found.residualBefore.xyMm2)});
    values.push_back({"xz", base::mm2(found.residual.xzMm2)});
    values.push_back({"xzBefore", base::mm2(found.residualBefore.xzMm2)});
  }
  if (row.objective == Objective::FewestMissed) {
    values.push_back({"missed", found.missed});
    values.push_back({"voxel", base::mm(found.searchMm)});
    values.push_back({"missedBefore", found.missedBefore});
  }
  if (row.objective == Objective::LeastTension) {
    values.push_back({"tension", base::number(found.tensionMPa)});
    values.push_back({"tensionBefore", base::number(found.tensionBeforeMPa)});
  }
  if (row.objective == Objective::MinAfterCuts) {
    values.push_back({"left", base::mm2(found.cuts.riskyMm2)});
    values.push_back({"pieces", found.cuts.pieces});
    values.push_back({"leftBefore", base::mm2(found.cutsBefore.riskyMm2)});
    values.push_back({"piecesBefore", found.cutsBefore.pieces});
  }
  return plan::makeFinding(found.areCutsChecked ? FindingKind::TurnedAfterCuts : row.turned,
                           std::move(values), std::nullopt, found.tried);
}

} // namespace

OrientationPlan orientationPlan(const modes::ModeChoices& in) {
  OrientationPlan plan;
  plan.objective = in.values.text("orient");
  if (plan.objective == "none")
    return plan;
  plan.voxelMm = in.values.number("voxelMm");
  plan.overhangRad = base::degreesToRadians(in.values.number("overhangAngle"));
  const placement::Objective objective = objectiveNamed(plan.objective).objective;
  if (objective == placement::Objective::FewestMissed)
    plan.platform = in.choices.item().platform;
  if (objective == placement::Objective::MinAfterCuts)
    plan.cuts = modes::cutEstimateOptions(in);
  return plan;
}

TurnedPart turnedPart(const geometry::TriangleMesh& placed, const geometry::Placement& placement,
                      const OrientationPlan& plan, double voxelMm, bool onlyQuarters,
                      const CheckedCuts& checkedCuts, const placement::TensionOf& tension,
                      const base::RunContext& ctx) {
  TurnedPart out;
  out.placement = placement;
  if (plan.objective == "none")
    return out;
  const base::Stopwatch clock;
  const ObjectiveRow& row = objectiveNamed(plan.objective);
  placement::OrientOptions options;
  options.voxelMm = voxelMm;
  options.overhangRad = plan.overhangRad;
  options.quarterTurns = onlyQuarters;
  options.centreMm = placement.centreMm;
  options.platform = [&](const voxel::SolidVoxels& part) {
    return modes::plateOf(plan.platform, part);
  };
  options.tension = tension;
  geometry::TriangleMesh coarse;
  if (plan.cuts) {
    coarse = geometry::simplified(placed, modes::kCutEstimateTriangles);
    options.cutOutcome = [&plan, &coarse, quiet = ctx.quiet()](const Eigen::Quaterniond& rotation) {
      const modes::CutEstimate cut = modes::estimatedCuts(
          geometry::place(coarse, 1.0, {rotation, Eigen::Vector2d::Zero(), 0.0}), *plan.cuts,
          quiet);
      return placement::CutOutcome{cut.riskyMm2, cut.pieces};
    };
    if (checkedCuts)
      options.checkedCuts = [&](const Eigen::Quaterniond& rotation) {
        geometry::Placement turned = placement;
        turned.rotation = (rotation * placement.rotation.normalized()).normalized();
        return checkedCuts(turned);
      };
  }
  const placement::Orientation found =
      placement::bestOrientation(placed, row.objective, options, ctx);
  const bool turned = found.rotation.angularDistance(Eigen::Quaterniond::Identity()) > kSame;
  if (turned)
    out.placement.rotation = (found.rotation * placement.rotation.normalized()).normalized();
  out.findings.push_back(findingOf(found, row, turned));
  out.seconds = clock.seconds();
  return out;
}

} // namespace voluta::pipeline
