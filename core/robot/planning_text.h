// The part of a robot file that planning depends on.
#pragma once

#include <string>
#include <string_view>

namespace voluta::robot {

// Returns the text of a robot file without its member "shape" (and the comma before it), so that a
// plan stays up to date if only the arm's appearance changes. Other texts are returned unchanged.
std::string planningText(std::string_view robotFile);

} // namespace voluta::robot
