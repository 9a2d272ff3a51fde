// Numbers of digital outputs and inputs in URScript.
#pragma once

namespace voluta::program {

// Outputs and inputs of ProgramEmitter from this number on are the configurable ones from 0 on: the
// last standard output is the cutter's (kCutOutput).
inline constexpr int kConfigurableFrom = 7;

} // namespace voluta::program
