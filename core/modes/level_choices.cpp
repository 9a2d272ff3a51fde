#include "modes/level_choices.h"

#include "base/error.h"
#include "base/units.h"
#include "modes/mode_stages.h"
#include "process/process.h"
#include "project/report.h"

#include <fmt/format.h>
#include <utility>

namespace voluta::modes {

double firstLayerMm(const ModeChoices& in) {
  const process::Process& p = in.process;
  const double first = in.values.number("firstLayerMm");
  if (first != 0.0 && (first < p.layerHeightMinMm || first > p.layerHeightMaxMm))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("{value} is outside the limits of process {process}"_text,
                                    base::mm(first), p.id),
                      "firstLayerMm"_name,
                      base::message("give 0, or {least#} to {most}"_text,
                                    base::mm(p.layerHeightMinMm), base::mm(p.layerHeightMaxMm)));
  return first;
}

substrate::LevelOptions levelOptions(const ModeChoices& in) {
  const process::Process& p = in.process;
  return {p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm, firstLayerMm(in), p.beadWidthMm};
}

substrate::OverhangRule overhangRule(const ModeChoices& in) {
  return {base::degreesToRadians(in.values.number("overhangAngle")), 0.5 * in.process.layerHeightMm,
          in.process.beadWidthMm};
}

void reportLevels(const substrate::OverhangRule& rule, int layers,
                  const substrate::Overhang& overhang, substrate::GroundKind ground,
                  DecomposeStage& stage) {
  project::DecompositionReport& r = stage.report;
  r.pieces = 1;
  r.layers = layers;
  r.riskyAreaMm2 = r.riskyAreaBeforeMm2 = overhang.areaMm2;
  if (auto finding = substrate::overhangFinding(overhang, rule, ground))
    stage.findings.push_back(std::move(*finding));
}

std::shared_ptr<const LayersStage> layersStage(substrate::StackedLevels stacked, double seconds) {
  auto stage = std::make_shared<LayersStage>();
  stage->report = stacked.statistics;
  stage->findings = std::move(stacked.findings);
  stage->timings.extract = seconds;
  stage->layers = layers::kept(std::move(stacked.stack));
  return stage;
}

} // namespace voluta::modes
