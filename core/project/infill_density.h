// A tool-path parameter that is not offered to users, because sparse infill does not pass the
// replay.
#pragma once

namespace voluta::project {

inline constexpr const char* kInfillDensity = "infillDensity";

} // namespace voluta::project
