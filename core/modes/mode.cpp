#include "modes/mode.h"

#include <fmt/format.h>

namespace voluta::modes {

Companions usualOnPlate() {
  const project::Choices first;
  return {first.cell, first.process, first.platform};
}

std::string heightsText(const process::Process& p) {
  return fmt::format("layer height {} in [{}, {}]\n", p.layerHeightMm, p.layerHeightMinMm,
                     p.layerHeightMaxMm);
}

std::string headText(const process::HeadShape& head) {
  std::string text;
  for (const process::HeadSection& s : head.sections)
    text += fmt::format("head {} {}\n", s.zMm, s.radiusMm);
  return text;
}

project::LayersReport reportOf(const layers::LayerStatistics& s) {
  project::LayersReport r;
  r.count = s.count;
  r.areaMm2 = s.areaMm2;
  r.thicknessMeanMm = s.thicknessMeanMm;
  r.thicknessStdMm = s.thicknessStdMm;
  r.thicknessP01Mm = s.thicknessP01Mm;
  r.thicknessP99Mm = s.thicknessP99Mm;
  r.withinLimitsFraction = s.withinLimitsFraction;
  return r;
}

} // namespace voluta::modes
