// The choices of an item of a job with everything that follows from them. Made once where a request
// or a job comes in, and handed down to all that need parameters, processes or tools.
#pragma once

#include "base/parameters.h"
#include "layers/tool_assignment.h"
#include "modes/from_options.h"
#include "process/tooling.h"
#include "project/choices.h"

#include <cstddef>

namespace voluta::planar {
struct RiskRule;
}

namespace voluta::pipeline {

struct Resolved {
  // Of this item only, and manual: with the parameters of the way that mode auto chose
  // (resolved()).
  project::Choices choices;
  // With the defaults of process, tool and mode (parameterValues()). Those of the job are the same
  // in all of its items.
  base::ParameterValues values;
  process::Tooling tooling; // with this item's layer height, bead width and step (chosenTooling())
  layers::ToolAssignment tools; // that print the item (chosenTools())
  bool isBesideOthers = false;  // one of several items, which have their places by arrangement

  // The process of the part's tool.
  const process::Process& process() const { return tooling.at(tools.part).process; }
  // Refers to this object.
  modes::ModeChoices modeChoices() const { return {choices, values, process()}; }
};

// Resolves the choices of the first item. Automatic choices that name no way keep their mode and
// platform. Throws Error{Usage} as parameterValues(), chosenTooling() and chosenTools().
Resolved resolve(const project::Choices& choices);
// Resolves the choices of one of the job's items. Throws as resolve().
Resolved resolveItem(const project::Choices& choices, std::size_t item);

// Returns the rule by which faces of pieces need support.
planar::RiskRule riskRule(const Resolved& resolved);

} // namespace voluta::pipeline
