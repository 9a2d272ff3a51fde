// The part of a robot's file that planning depends on.
#pragma once

#include <string>
#include <string_view>

namespace voluta::robot {

// The text of a robot's file without its member "shape" (and the comma before it), so that a plan
// stays up to date when only the arm's look changes. Any other text comes back as it is.
std::string planningText(std::string_view robotFile);

} // namespace voluta::robot
