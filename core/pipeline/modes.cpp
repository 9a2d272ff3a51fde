#include "pipeline/modes.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "pipeline/choices.h"
#include "voxel/solid_voxels.h"

namespace voluta::pipeline {

namespace {

void append(plan::Findings& findings, const plan::Findings& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

void reportDecomposition(const curved::Decomposition& d, Report& report) {
  DecompositionReport& r = report.decomposition;
  r.growth = d.growth;
  r.voxelMm = d.grid.pitch;
  r.voxels = d.voxels;
  r.layers = d.layers;
  r.missedVoxels = r.missedAfterSupports = d.missedVoxels;
  r.shadowedVoxels = d.shadowedVoxels;
  r.unreachedVoxels = d.unreachedVoxels;
  r.pieces = 1;
  append(report.findings, d.findings);
  report.timings.peel += d.seconds.peel;
  report.timings.grow += d.seconds.grow;
  report.timings.smooth += d.seconds.smooth;
}

void reportLayers(const curved::LayersResult& l, Report& report) {
  LayersReport& r = report.layers;
  r.count = l.statistics.count;
  r.areaMm2 = l.statistics.areaMm2;
  r.thicknessMeanMm = l.statistics.thicknessMeanMm;
  r.thicknessStdMm = l.statistics.thicknessStdMm;
  r.thicknessP01Mm = l.statistics.thicknessP01Mm;
  r.thicknessP99Mm = l.statistics.thicknessP99Mm;
  r.withinLimitsFraction = l.statistics.withinLimitsFraction;
  append(report.findings, l.findings);
  report.timings.extract += l.seconds.extract;
  report.timings.trim += l.seconds.trim;
}

ModeResult buildCurved(const ModeInput& in, Report& report, const base::RunContext& ctx) {
  ModeResult result;
  base::Stopwatch voxelising;
  ctx.report(0.0, "voxelise");
  const voxel::SolidVoxels solid =
      voxel::solidVoxels(in.part, in.values.number("voxelMm"), ctx.sub(0.0, 0.05));
  report.timings.voxelise = voxelising.seconds();
  result.platform = platformPolygon(in.choices.platform, solid);

  curved::CurvedOptions growth;
  growth.growth = in.choices.growth;
  growth.layerHeightMm = in.process.layerHeightMm;
  growth.heightMinMm = in.process.layerHeightMinMm;
  growth.heightMaxMm = in.process.layerHeightMaxMm;
  growth.rounds = static_cast<int>(in.values.integer("fieldRounds"));
  const auto decomposition = std::make_shared<curved::Decomposition>(
      curved::decompose(solid, result.platform, growth, ctx.sub(0.05, 0.7)));
  reportDecomposition(*decomposition, report);
  result.decomposition = decomposition;
  if (in.untilDecompose)
    return result;

  curved::LayerOptions cut;
  cut.layerHeightMm = in.process.layerHeightMm;
  cut.heightMinMm = in.process.layerHeightMinMm;
  cut.heightMaxMm = in.process.layerHeightMaxMm;
  cut.beadWidthMm = in.process.beadWidthMm;
  curved::LayersResult layers =
      curved::curvedLayers(*decomposition, in.part, cut, ctx.sub(0.7, 1.0));
  reportLayers(layers, report);
  result.layers = std::make_shared<layers::LayerStack>(std::move(layers.stack));
  return result;
}

} // namespace

const std::vector<Mode>& modes() {
  static const std::vector<Mode> kModes{{"curved", "Curved layers", buildCurved}};
  return kModes;
}

const Mode& findMode(std::string_view id) {
  for (const Mode& mode : modes())
    if (mode.id == id)
      return mode;
  base::failPrecondition("mode is in the table");
}

} // namespace voluta::pipeline
