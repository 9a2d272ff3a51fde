// The part of the module that reads G-code on the controller which is the same for every job
// (program/gcode/gcode_rapid.h).
#pragma once

#include <string_view>

namespace voluta::program {

// Returns the text from its first line on, which is a remark; lines end with LF only.
std::string_view rapidGcodeSame();
// Returns that first line.
std::string_view rapidGcodeSameBegin();

} // namespace voluta::program
