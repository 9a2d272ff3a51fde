// What of the module that reads G-code on the controller is the same for every job
// (program/gcode/gcode_rapid.h).
#pragma once

#include <string_view>

namespace voluta::program {

// From its first line on, a remark; lines end with LF alone.
std::string_view rapidGcodeSame();
// That line.
std::string_view rapidGcodeSameBegin();

} // namespace voluta::program
