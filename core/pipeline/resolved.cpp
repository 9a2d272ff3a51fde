#include "pipeline/resolved.h"

#include "modes/planar_modes.h"
#include "pipeline/automatic.h"
#include "pipeline/stage_options.h"

#include <utility>

namespace voluta::pipeline {

Resolved resolve(const project::Choices& choices) {
  project::Choices manual = resolved(project::onlyItem(choices, 0));
  base::ParameterValues values = parameterValues(manual);
  process::Tooling tooling = chosenTooling(manual, values);
  layers::ToolAssignment tools = chosenTools(values, tooling);
  return {std::move(manual), std::move(values), std::move(tooling), std::move(tools)};
}

Resolved resolveItem(const project::Choices& choices, std::size_t item) {
  Resolved own = resolve(project::onlyItem(choices, item));
  own.isBesideOthers = choices.items.size() > 1;
  return own;
}

planar::RiskRule riskRule(const Resolved& resolved) {
  return modes::riskRule(resolved.modeChoices());
}

} // namespace voluta::pipeline
