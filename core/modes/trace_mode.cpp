#include "modes/trace_mode.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/append_mesh.h"
#include "geometry/convex_polygon.h"
#include "layers/layer_checks.h"
#include "layers/order.h"
#include "modes/mode_stages.h"
#include "platform/platform_solid.h"
#include "process/bead_model.h"
#include "process/process.h"
#include "project/choices.h"
#include "substrate/bead_strip.h"
#include "substrate/trace_seam.h"

#include <utility>

namespace voluta::modes {

namespace {

struct TracePlan {
  project::Platform platform;
  double standsMm; // points up to this height count as on the plate
  substrate::SeamRule rule;
  substrate::StripSize strip;
};

TracePlan tracePlan(const ModeChoices& in) {
  constexpr double kContactShare = 0.5, kMinWidths = 4.0;
  const process::Process& p = in.process;
  TracePlan plan{in.choices.item().platform, kContactShare * p.layerHeightMm, {}, {}};
  plan.rule.steepRad = base::degreesToRadians(in.values.number("traceAngle"));
  plan.rule.closingMm = in.values.number("traceClosing");
  plan.rule.insetMm = in.values.number("traceInset");
  plan.rule.spacingMm = in.values.number("traceSpacing");
  if (plan.rule.spacingMm <= 0.0)
    plan.rule.spacingMm = p.beadWidthMm;
  plan.rule.curves = static_cast<int>(in.values.integer("tracePasses"));
  plan.rule.sideCurves = static_cast<int>(in.values.integer("traceSidePasses"));
  plan.rule.sideDepthMm = in.values.number("traceSideDepth");
  plan.rule.fillLines = static_cast<int>(in.values.integer("traceFillLines"));
  plan.rule.fillRad = base::degreesToRadians(in.values.number("traceFillAngle"));
  plan.rule.stepMm = p.stepMm;
  plan.rule.minMm = kMinWidths * p.beadWidthMm;
  // The width at which beads fill a layer, so that the strip has the volume of one bead.
  plan.strip = {process::hatchOf(p.beadWidthMm, p.layerHeightMm), p.layerHeightMm};
  return plan;
}

struct BodyPlan {
  project::Platform platform;
  double standsMm;
};

BodyPlan bodyPlan(const ModeChoices& in) {
  const TracePlan plan = tracePlan(in);
  return {plan.platform, plan.standsMm};
}

// The body lies on the plate.
platform::PlatformSolid bodyOf(const BodyPlan& plan, const LoadStage& placed) {
  std::vector<Eigen::Vector2d> on;
  for (const Eigen::Vector3d& v : placed.part->vertices)
    if (v.z() <= plan.standsMm)
      on.emplace_back(v.head<2>());
  platform::PlatformSolid platform;
  platform.polygon = plan.platform.plateAround(geometry::convexPolygon(std::move(on)));
  platform.mesh = placed.part;
  return platform;
}

std::vector<substrate::SeamCurve>
curvesOf(const TracePlan& plan, const geometry::TriangleMesh& body, const base::RunContext& ctx) {
  std::vector<substrate::SeamCurve> curves = substrate::seamCurves(body, plan.rule, ctx);
  if (curves.empty())
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("the part has no surface within {angle} of the vertical that "
                                    "is wide enough for a seam"_text,
                                    base::degrees(base::radiansToDegrees(plan.rule.steepRad))),
                      "traceAngle"_name, "turn the part, or increase `traceAngle`"_text);
  return curves;
}

std::shared_ptr<const DecomposeStage> decompose(const TracePlan& plan, const DecomposeInput& input,
                                                const base::RunContext& ctx) {
  const base::Stopwatch watch;
  ctx.report(0.0, "find the seam"_text);
  auto stage = std::make_shared<DecomposeStage>();
  stage->platform = bodyOf({plan.platform, plan.standsMm}, input.placed);
  const auto beads = std::make_shared<geometry::TriangleMesh>();
  for (const substrate::SeamCurve& curve : curvesOf(plan, *input.placed.part, ctx))
    geometry::appendMesh(*beads, substrate::stripSolid(curve, plan.strip));
  stage->result = project::ReducedPlatform{beads};
  stage->report.pieces = 1;
  stage->report.layers = 1;
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::shared_ptr<const LayersStage> layersOf(const TracePlan& plan, const DecomposeStage& decomposed,
                                            const LayersInput&, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  layers::LayerStack stack;
  for (const substrate::SeamCurve& curve : curvesOf(plan, *decomposed.platform.mesh, ctx))
    stack.patches.push_back(substrate::stripPatch(curve, plan.strip));
  layers::numberLayers(stack);
  auto stage = std::make_shared<LayersStage>();
  stage->report = layers::layerStatistics(stack);
  stage->layers = layers::kept(std::move(stack));
  stage->timings.extract = watch.seconds();
  return stage;
}

} // namespace

Mode traceMode() {
  Mode mode{"trace",
            "Trace on a surface"_text,
            {tracePlan, decompose},
            {tracePlan, layersOf},
            project::ResultKind::OnGround,
            {"overhangAngle", "traceAngle", "traceInset", "traceSpacing", "tracePasses",
             "traceClosing", "traceSidePasses", "traceSideDepth", "traceFillLines",
             "traceFillAngle"}};
  mode.onPart = true;
  mode.platform = {bodyPlan, bodyOf};
  mode.defaults = {{"walls", "1"}};
  return mode;
}

base::ParameterTable traceParameters() {
  const substrate::SeamRule d;
  return base::ParameterTable({
      base::numberParameter("traceAngle", "deg", base::radiansToDegrees(d.steepRad), 1.0, 85.0,
                            "Trace"_text, "greatest angle of the traced surface"_text,
                            "Mode trace: the seam is the outline of the part's surface whose "
                            "normal is within this angle of the vertical."_text,
                            true),
      base::numberParameter("traceInset", "mm", d.insetMm, 0.0, 1000.0, "Trace"_text,
                            "inset of the seam"_text,
                            "Distance of the first bead from the outline, inwards, seen from "
                            "above."_text,
                            true),
      base::integerParameter("tracePasses", d.curves, 1, 1000, "Trace"_text, "seams"_text,
                             "Number of beads from the outline inwards."_text, true),
      base::numberParameter("traceSpacing", "mm", 0.0, 0.0, 1000.0, "Trace"_text,
                            "distance of seams"_text,
                            "Distance between beads, seen from above. 0: the bead's width."_text),
      base::integerParameter(
          "traceSidePasses", d.sideCurves, 0, 1000, "Trace"_text, "side passes"_text,
          "Number of beads on the side of the part, below the outline."_text, true),
      base::numberParameter("traceSideDepth", "mm", d.sideDepthMm, 0.0, 1000.0, "Trace"_text,
                            "depth of side passes"_text,
                            "Height of the outline above the first side pass."_text, true),
      base::integerParameter("traceFillLines", d.fillLines, 0, 1000, "Trace"_text,
                             "lines at heel and toe"_text,
                             "Number of parallel beads that fill each of the two ends inside the "
                             "innermost seam."_text,
                             true),
      base::numberParameter("traceFillAngle", "deg", base::radiansToDegrees(d.fillRad), -180.0,
                            180.0, "Trace"_text, "angle of lines"_text,
                            "Angle of the lines at heel and toe to the x axis, seen from "
                            "above."_text),
      base::numberParameter("traceClosing", "mm", d.closingMm, 0.0, 100.0, "Trace"_text,
                            "radius of the outline's hull"_text,
                            "Gaps of the outline through which no disc of this radius passes are "
                            "closed."_text),
  });
}

} // namespace voluta::modes
