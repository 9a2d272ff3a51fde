// The ways of building a part: one row a mode.
#pragma once

#include "base/parameters.h"
#include "modes/mode.h"

#include <string_view>
#include <vector>

namespace voluta::modes {

const std::vector<Mode>& modeTable();
// Null: no mode has that id.
const Mode* modeNamed(std::string_view id);
// Precondition: the id is known.
const Mode& findMode(std::string_view id);

// What all modes ask for.
base::ParameterTable modeParameters();
// Has a parameter, of a mode or of any stage, a say in what that mode makes?
bool takesParameter(const Mode& mode, std::string_view key);

} // namespace voluta::modes
