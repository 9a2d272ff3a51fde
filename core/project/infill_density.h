// A parameter that tool-paths know and that nobody is offered yet: sparse infill does not pass the
// replay.
#pragma once

namespace voluta::project {

inline constexpr const char* kInfillDensity = "infillDensity";

} // namespace voluta::project
