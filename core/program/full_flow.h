// Meaning of the extruder's flow output: a comment in a program's head by which the operator sets
// up the extruder.
#pragma once

#include "plan/program.h"
#include "plan/stated_facts.h"
#include "process/tooling.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// For URScript's analogue output.
inline constexpr std::string_view k0To10V = "0 to 10 V";

// Returns a text such as "1 = 40 mm3/s"; `atFull`: the output's maximum (Dialect::fullFlowAt).
std::string fullFlowText(std::string_view atFull, const process::Tooling& tooling);

// Returns the statements in the heads of the files: comments that begin with "extruder" and contain
// "flow: " followed by " = ". Number 0: not understood.
std::vector<plan::StatedFact> statedFullFlow(const std::vector<plan::ProgramFile>& files);

} // namespace voluta::program
