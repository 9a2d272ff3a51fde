// What goes with a way of building: a rod needs a cell that turns one, a body its file.
#pragma once

#include "base/parameters.h"
#include "geometry/placement.h"
#include "project/job.h"

#include <QString>
#include <map>
#include <string>

namespace voluta::document {

// Ways of building stand on a plate or turn with a rod. Cell, process, platform and place of the
// part are kept for either: whoever comes back finds them as they were.
class ModeSwitch {
public:
  // The choices in that mode: with what they have where it fits, else with what was there when the
  // mode's kind was last left, else with what is usual for it. Precondition: known modes.
  project::Choices switched(const project::Choices& now, const std::string& mode);
  // The choices with way of building and platform left to the plan.
  project::Choices automatic(const project::Choices& now);

private:
  struct Defaults {
    std::string cell, process;
    geometry::Placement placement;
  };
  std::map<bool, Defaults> companions_;                // by Mode::aroundRod
  std::map<std::string, project::Platform> platforms_; // by mode
};

// The choices with all replaced that does not fit their mode; the same where nothing is to be.
// Reads descriptions of cells.
project::Choices fitting(project::Choices choices);

// The parameters with the defaults that the choices' mode and process have, and, where the way of
// building is left to the plan, with the values of the way that was taken last.
base::ParameterTable parametersFor(const project::Choices& choices);

// What keeps anything from being planned with these choices, a parameter apart: one sentence, or
// none. Reads descriptions of cell and process.
QString obstacle(const project::Choices& choices);

} // namespace voluta::document
