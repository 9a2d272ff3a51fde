#include "modes/curved_mode.h"

#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/forward_growth.h"
#include "modes/curved_supports.h"
#include "modes/parameter_text.h"
#include "modes/part_voxels.h"
#include "modes/plate.h"

#include <fmt/format.h>

namespace voluta::modes {

namespace {

// The head that the front may have the shape of, shrunk by what counts as contact; none for flat.
process::HeadShape frontHead(const ModeChoices& in) {
  if (in.values.text("frontShape") == "flat")
    return {};
  return process::erodedHead(in.process.head, in.process.contactToleranceMm);
}

std::string curvedDecomposeKey(const ModeChoices& in) {
  std::string key = fmt::format("growth {}\nplatform {}\n{}", in.choices.growth.id(),
                                in.choices.platform.text(), heightsText(in.process)) +
                    parameterText(curved::curvedParameters(), in.values) +
                    parameterText(support::supportParameters(), in.values);
  if (!in.choices.growth.row().peels)
    key += parameterText(curved::forwardParameters(), in.values);
  return key + headText(frontHead(in));
}

std::shared_ptr<const DecomposeStage> decomposeCurved(const DecomposeInput& input,
                                                      const base::RunContext& ctx) {
  const ModeChoices& in = input.choices;
  auto stage = std::make_shared<DecomposeStage>();
  ctx.report(0.0, "voxelise"_text);
  const std::shared_ptr<const PartVoxels> part = input.voxels(ctx.sub(0.0, 0.07));
  const voxel::SolidVoxels& solid = *part->voxels;
  stage->timings.voxelise = part->seconds;
  stage->platform = plateOf(in.choices.platform, solid, input.placed.platform);

  curved::CurvedOptions growth;
  growth.growth = in.choices.growth;
  growth.forward = curved::forwardOptions(in.values);
  growth.layerHeightMm = in.process.layerHeightMm;
  growth.heightMinMm = in.process.layerHeightMinMm;
  growth.heightMaxMm = in.process.layerHeightMaxMm;
  growth.head = frontHead(in);
  growth.headForLosses = in.values.text("frontShape") == "nozzle";
  growth.rounds = static_cast<int>(in.values.integer("fieldRounds"));
  const support::Supports supports =
      supportsOf(solid, stage->platform.polygon, growth, in.values, ctx.sub(0.07, 0.2));
  curved::DecompositionWatch watch;
  if (input.onPreview)
    watch = [&](const curved::Decomposition& soFar) {
      const auto copy = std::make_shared<curved::Decomposition>(soFar);
      markSupports(supports, *copy);
      input.onPreview(copy);
    };
  const auto decomposition = std::make_shared<curved::Decomposition>(
      curved::decompose(supports.solid, stage->platform.polygon, growth, ctx.sub(0.2, 1.0), watch));
  markSupports(supports, *decomposition);
  const curved::Decomposition& d = *decomposition;
  project::DecompositionReport& r = stage->report;
  r.mode = in.choices.mode;
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
  tellSupports(supports, *stage);
  stage->decomposition = decomposition;
  return stage;
}

std::string curvedLayersKey(const ModeChoices& in) {
  return fmt::format("{}bead width {}\n", heightsText(in.process), in.process.beadWidthMm);
}

std::shared_ptr<const LayersStage> curvedLayersOf(const DecomposeStage& decomposed,
                                                  const geometry::TriangleMesh& part,
                                                  const ModeChoices& in,
                                                  const base::RunContext& ctx) {
  auto stage = std::make_shared<LayersStage>();
  curved::LayerOptions cut;
  cut.layerHeightMm = in.process.layerHeightMm;
  cut.heightMinMm = in.process.layerHeightMinMm;
  cut.heightMaxMm = in.process.layerHeightMaxMm;
  cut.beadWidthMm = in.process.beadWidthMm;
  curved::LayersResult layers =
      curved::curvedLayers(*decomposed.decomposition, part, cut, ctx,
                           supportPatches(*decomposed.decomposition, part, cut, ctx));
  stage->report = reportOf(layers.statistics);
  stage->findings = std::move(layers.findings);
  stage->timings.extract = layers.seconds.extract;
  stage->timings.trim = layers.seconds.trim;
  stage->layers = std::make_shared<layers::LayerStack>(std::move(layers.stack));
  return stage;
}

} // namespace

Mode curvedMode() {
  Mode mode{"curved",        "Curved layers"_text, curvedDecomposeKey,
            curvedLayersKey, decomposeCurved,      curvedLayersOf};
  mode.grows = true;
  for (const base::ParameterTable& table :
       {curved::curvedParameters(), curved::forwardParameters(), support::supportParameters()})
    for (const base::ParameterSpec& spec : table.specs())
      mode.parameters.push_back(spec.key);
  mode.parameters.emplace_back("overhangAngle"); // where the part is turned by it
  return mode;
}

} // namespace voluta::modes
