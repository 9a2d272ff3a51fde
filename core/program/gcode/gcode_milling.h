// Reads the G-code of a milling machine that turns the block about its axis A (RS-274, as LinuxCNC
// and Grbl understand it).
#pragma once

#include "plan/program.h"

#include <string_view>

namespace voluta::program {

inline constexpr std::string_view kMillingFormat = "milling";

// Motions are ToolPoint: the cutter's tip in the coordinates of the last TargetFrame fact (G54,
// G55), upright. Rapid ones (G0) have no speed. Facts: Home (G53 Z0, the reference position),
// BlockTurned (A), Spindle (S with M3, M5), TargetFrame. Never throws on bad text: each line that
// is not understood is a defect, as is a motion before its axes, its feed or its units are stated.
plan::ReadProgram readMillingGcode(std::string_view text);

} // namespace voluta::program
