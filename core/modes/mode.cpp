#include "modes/mode.h"

#include <algorithm>

namespace voluta::modes {

Defaults usualOnPlate() {
  const project::Choices first;
  return {first.cell, first.tool().process, first.item().platform};
}

bool Mode::requiresParameter(std::string_view parameter) const {
  return std::find(parameters.begin(), parameters.end(), parameter) != parameters.end();
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
