// How every job file begins.
#pragma once

#include <string_view>

namespace voluta::project {

inline constexpr std::string_view kJobMagic = "VOLUTA ";

} // namespace voluta::project
