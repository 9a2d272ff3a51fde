// How project files begin: those of a job, and those of a station of several machines.
#pragma once

#include <string_view>

namespace voluta::project {

inline constexpr std::string_view kJobMagic = "VOLUTA ";
inline constexpr std::string_view kStationMagic = "VOLUTA STATION ";

} // namespace voluta::project
