// Help of options that several commands have.
#pragma once

namespace voluta::cli {

inline constexpr const char* kReplaceHelp = "also replace files of the same names in the folder "
                                            "that are of another program or another kind "
                                            "of job";
inline constexpr const char* kCellHelp = "robot cell (see: list cells), or FILE.json";
inline constexpr const char* kProcessHelp =
    "nozzle, material, speeds (see: list processes), or FILE.json";
inline constexpr const char* kUnitsHelp = "units of the mesh file: um, mm, cm, in, m";
inline constexpr const char* kPartHelp = "file of a part (see: list parts), or sample:NAME";

inline constexpr const char* kRegionHelp =
    "SHAPE[;use=USE][;KEY=VALUE]...: a place in a part with settings or layers of its own; see the "
    "manual, Regions";

} // namespace voluta::cli
