#include "modes/curved_mode.h"

#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/grow.h"
#include "curved/platform_polygon.h"
#include "curved/voxel_graph.h"
#include "modes/curved_supports.h"
#include "modes/growth_plate.h"
#include "modes/part_voxels.h"
#include "modes/region_supports.h"
#include "plan/finding_kinds.h"
#include "project/choices.h"
#include "support/supports.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace voluta::modes {

namespace {

// Returns the head shape for a front shaped like the nozzle, shrunk by the contact tolerance; an
// empty shape for a flat front.
process::HeadShape frontHead(const ModeChoices& in) {
  if (in.values.text("frontShape") == "flat")
    return {};
  return process::erodedHead(in.process.head, in.process.contactToleranceMm);
}

struct CurvedPlan {
  double voxelMm;
  project::Platform platform;
  curved::CurvedOptions growth;
  layers::SupportRule supports; // outside of regions
  double bridgeMm;              // longest bridge of supports [mm]; 0 without supports
};

CurvedPlan planOf(const ModeChoices& in) {
  CurvedPlan plan{in.values.number("voxelMm"),
                  in.choices.item().platform,
                  {},
                  support::supportRule(in.values),
                  supportsSomewhere(in) ? in.process.bridgeMm : 0.0};
  curved::CurvedOptions& growth = plan.growth;
  growth.growth = in.choices.item().growth;
  growth.layerHeightMm = in.process.layerHeightMm;
  growth.heightMinMm = in.process.layerHeightMinMm;
  growth.heightMaxMm = in.process.layerHeightMaxMm;
  growth.head = frontHead(in);
  growth.headForLosses = in.values.text("frontShape") == "nozzle";
  growth.rounds = static_cast<int>(in.values.integer("fieldRounds"));
  return plan;
}

// Returns a finding if a pedestal as wide as the part's foot would save at least half of the voxels
// that need columns (Boge 2019, 6.2.3 and 6.4).
std::optional<plan::Finding> pedestalGains(const voxel::SolidVoxels& part, const CurvedPlan& plan,
                                           std::size_t missedHere, const base::RunContext& ctx) {
  if (missedHere == 0 || plan.platform.marginMm())
    return std::nullopt;
  const curved::VoxelGraph graph =
      curved::voxelGraph(part.grid, part.solid, part.plateLayer(), curved::platformFit(part, 0.0));
  const curved::CurvedOptions& o = plan.growth;
  const curved::Growth growth =
      curved::grow(graph, o.growth, o.forward, ctx, curved::headForLosses(o));
  const std::size_t there = part.count - std::min(part.count, growth.printed);
  if (2 * there > missedHere)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::PedestalGains,
                           {{"here", missedHere}, {"there", there}}, std::nullopt, missedHere);
}

std::shared_ptr<const DecomposeStage>
decomposeCurved(const CurvedPlan& plan, const DecomposeInput& input, const base::RunContext& ctx) {
  auto stage = std::make_shared<DecomposeStage>();
  ctx.report(0.0, "voxelise"_text);
  const std::shared_ptr<const PartVoxels> part = input.voxels(plan.voxelMm, ctx.sub(0.0, 0.07));
  const voxel::SolidVoxels& solid = *part->voxels;
  stage->timings.voxelise = part->seconds;
  stage->platform = plateOf(plan.platform, solid, input.placed.platform);

  const curved::CurvedOptions& growth = plan.growth;
  const support::Supports supports =
      supportsOf(solid, stage->platform.polygon, growth, {plan.supports, plan.bridgeMm},
                 input.supports ? *input.supports : layers::SupportPlaces(), ctx.sub(0.07, 0.2));
  curved::DecompositionWatch watch;
  if (input.onPreview)
    watch = [&](const curved::Decomposition& soFar) {
      const auto copy = std::make_shared<curved::Decomposition>(soFar);
      markSupports(supports, *copy);
      input.onPreview(copy);
    };
  const auto decomposition = std::make_shared<curved::Decomposition>(
      curved::decompose(supports.solid, stage->platform.polygon, growth, ctx.sub(0.2, 1.0), watch,
                        input.isRejected, supports.growth));
  markSupports(supports, *decomposition);
  const curved::Decomposition& d = *decomposition;
  project::DecompositionReport& r = stage->report;
  r.growth = d.growth;
  r.voxelMm = d.grid.pitch;
  r.voxels = d.voxels;
  r.layers = d.layers;
  r.missedVoxels = d.missedVoxels;
  r.shadowedVoxels = d.shadowedVoxels;
  r.unreachedVoxels = d.unreachedVoxels;
  r.pieces = 1;
  stage->findings = part->findings;
  stage->findings.insert(stage->findings.end(), d.findings.begin(), d.findings.end());
  stage->timings.peel = d.seconds.peel;
  stage->timings.grow = d.seconds.grow;
  stage->timings.smooth = d.seconds.smooth;
  reportSupports(supports, *stage);
  const bool rejected = input.isRejected && input.isRejected(d.findings);
  if (const auto gains =
          rejected ? std::nullopt : pedestalGains(solid, plan, supports.missedBefore, ctx.quiet()))
    stage->findings.push_back(*gains);
  stage->result = project::Voxels(decomposition);
  return stage;
}

curved::LayerOptions layerOptions(const ModeChoices& in) {
  curved::LayerOptions cut;
  cut.layerHeightMm = in.process.layerHeightMm;
  cut.heightMinMm = in.process.layerHeightMinMm;
  cut.heightMaxMm = in.process.layerHeightMaxMm;
  cut.beadWidthMm = in.process.beadWidthMm;
  return cut;
}

std::shared_ptr<const LayersStage> curvedLayersOf(const curved::LayerOptions& cut,
                                                  const DecomposeStage& decomposed,
                                                  const LayersInput& input,
                                                  const base::RunContext& ctx) {
  auto stage = std::make_shared<LayersStage>();
  const geometry::TriangleMesh& part = input.part;
  const curved::Decomposition& decomposition = *std::get<project::Voxels>(decomposed.result);
  curved::LayersResult layers = curved::curvedLayers(decomposition, part, cut, ctx,
                                                     supportPatches(decomposition, part, cut, ctx));
  stage->report = layers.statistics;
  stage->findings = std::move(layers.findings);
  stage->timings.extract = layers.seconds.extract;
  stage->timings.trim = layers.seconds.trim;
  stage->layers = layers::kept(std::move(layers.stack));
  return stage;
}

} // namespace

Mode curvedMode() {
  Mode mode{"curved",
            "Curved layers"_text,
            {planOf, decomposeCurved},
            {layerOptions, curvedLayersOf},
            project::ResultKind::InVoxels,
            {"voxelMm", "frontShape", "fieldRounds", "supports", "overhangAngle"}};
  mode.grows = true;
  // Near a plate a flat front misses voxels that the real head reaches. The nozzle-shaped front
  // misses few, and thin columns support those.
  mode.defaults = {{"frontShape", "nozzle"}, {"supports", "auto"}};
  return mode;
}

} // namespace voluta::modes
