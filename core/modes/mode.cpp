#include "modes/mode.h"

#include "project/choices.h"

#include <algorithm>

namespace voluta::modes {

Defaults usualOnPlate() {
  const project::Choices first;
  return {first.cell, first.tool().process, first.item().platform};
}

bool Mode::requiresParameter(std::string_view parameter) const {
  return std::find(parameters.begin(), parameters.end(), parameter) != parameters.end();
}

} // namespace voluta::modes
