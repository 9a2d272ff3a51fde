// Harm to what a program lays, of a whole stretch of it, as the dialect says flow.
#pragma once

#include "replay/mutations.h"

#include <cstddef>
#include <string>

namespace voluta::test {

// Over so many lines the extruder gives only this share of what it should; before and behind them
// all is as it was. At the line: where that begins.
Mutation lowerFlow(const std::string& format, double share, std::size_t lines);

} // namespace voluta::test
