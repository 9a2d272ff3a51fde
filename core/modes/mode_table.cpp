#include "modes/mode_table.h"

#include "base/error.h"
#include "curved/decompose.h"
#include "modes/curved_mode.h"
#include "modes/lathe_mode.h"
#include "modes/planar_modes.h"
#include "modes/substrate_mode.h"
#include "modes/trace_mode.h"
#include "support/supports.h"

#include <algorithm>

namespace voluta::modes {

const std::vector<Mode>& modeTable() {
  static const std::vector<Mode> kModes{curvedMode(), planarMode(),    flatMode(),
                                        latheMode(),  substrateMode(), traceMode()};
  return kModes;
}

const Mode* modeNamed(std::string_view id) {
  for (const Mode& mode : modeTable())
    if (mode.id == id)
      return &mode;
  return nullptr;
}

const Mode& findMode(std::string_view id) {
  const Mode* mode = modeNamed(id);
  base::require(mode != nullptr, "mode is in the table");
  return *mode;
}

base::ParameterTable modeParameters() {
  base::ParameterTable table = curved::curvedParameters();
  table.append(planarModeParameters());
  table.append(latheParameters());
  table.append(substrateParameters());
  table.append(traceParameters());
  table.append(support::supportParameters());
  return table;
}

bool printAlike(const Mode& a, const Mode& b) {
  const auto takesBody = [](const Mode& mode) {
    return std::ranges::find(mode.platforms, project::PlatformUse::Body) != mode.platforms.end();
  };
  return a.aroundRod == b.aroundRod && a.onPart == b.onPart && takesBody(a) == takesBody(b);
}

bool takesParameter(const Mode& mode, std::string_view key) {
  if (key == "voxelMm") // also the unit of voxel objects
    return true;
  if (key == "orient") // a mode that places parts itself does not reorient them
    return !mode.place;
  return !modeParameters().find(key) || mode.requiresParameter(key);
}

} // namespace voluta::modes
