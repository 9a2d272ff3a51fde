#include "pipeline/modes.h"

#include "base/error.h"
#include "pipeline/curved_mode.h"
#include "pipeline/lathe_mode.h"
#include "pipeline/planar_modes.h"
#include "pipeline/road.h"
#include "pipeline/substrate_mode.h"

#include <fmt/format.h>
#include <utility>

namespace voluta::pipeline {

const std::vector<Mode>& modes() {
  static const std::vector<Mode> kModes{curvedMode(), planarMode(), flatMode(), latheMode(),
                                        substrateMode()};
  return kModes;
}

const Mode& findMode(std::string_view id) {
  for (const Mode& mode : modes())
    if (mode.id == id)
      return mode;
  base::failPrecondition("mode is in the table");
}

base::ParameterTable parametersOf(std::string_view id) {
  std::vector<base::ParameterSpec> specs = allParameters().specs();
  for (const Mode& mode : modes())
    for (const auto& [key, text] : mode.defaults)
      for (base::ParameterSpec& spec : specs)
        if (mode.id == id && spec.key == key)
          spec.defaultValue = base::parseParameter(spec, text);
  return base::ParameterTable(std::move(specs));
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

LayersReport reportOf(const layers::LayerStatistics& s) {
  LayersReport r;
  r.count = s.count;
  r.areaMm2 = s.areaMm2;
  r.thicknessMeanMm = s.thicknessMeanMm;
  r.thicknessStdMm = s.thicknessStdMm;
  r.thicknessP01Mm = s.thicknessP01Mm;
  r.thicknessP99Mm = s.thicknessP99Mm;
  r.withinLimitsFraction = s.withinLimitsFraction;
  return r;
}

} // namespace voluta::pipeline
