// Help of an option that several commands have.
#pragma once

namespace voluta::cli {

inline constexpr const char* kReplaceHelp =
    "also replace files of the same names in the folder that are of another job or program";

} // namespace voluta::cli
