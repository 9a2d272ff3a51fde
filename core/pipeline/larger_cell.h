// A cell with more room than the one that was chosen.
#pragma once

#include "project/choices.h"

#include <optional>
#include <string>

namespace voluta::pipeline {

// Returns the id of the cell whose largest plate is the smallest one longer than that of the chosen
// cell; of equals the first. It moves the nozzle or the plate as the chosen one does where there is
// such a cell. nullopt: no plate is longer, or the mode prints around a rod. Throws Error{Usage}
// for a cell or a process that nothing answers to.
std::optional<std::string> cellWithLargerPlate(const project::Choices& choices);

} // namespace voluta::pipeline
