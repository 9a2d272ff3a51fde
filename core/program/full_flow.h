// What the extruder's flow output stands for: a remark in a program's head, by which the operator
// sets the extruder up.
#pragma once

#include "plan/program.h"
#include "plan/stated_facts.h"
#include "process/process.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Of URScript's analogue output.
inline constexpr std::string_view k0To10V = "0 to 10 V";

// "1 = 40 mm3/s"; `atFull`: the output's greatest value (Dialect::fullFlowAt).
std::string fullFlowText(std::string_view atFull, const process::Process& process);

// What the heads of the files say of it: remarks that begin with "extruder" and have "flow: " and,
// behind it, " = ". Number 0: not understood.
std::vector<plan::StatedFact> statedFullFlow(const std::vector<plan::ProgramFile>& files);

} // namespace voluta::program
