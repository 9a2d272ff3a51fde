// The table of all modes.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

#include <string_view>
#include <vector>

namespace voluta::modes {

const std::vector<Mode>& modeTable();
// Returns nullptr if no mode has that id.
const Mode* modeNamed(std::string_view id);
// Precondition: the id is known.
const Mode& findMode(std::string_view id);

// Returns whether both modes print the same kind of part in the same cell: on a plate, around a
// rod, on a surface, or on the part itself.
bool printAlike(const Mode& a, const Mode& b);

// Returns the parameters of all modes.
base::ParameterTable modeParameters();
// Returns whether a parameter (of a mode or of any stage) affects the results of that mode.
bool takesParameter(const Mode& mode, std::string_view key);

} // namespace voluta::modes
