// Damage to the deposition of a whole stretch of a program, in the dialect's words for flow.
#pragma once

#include "replay/mutations.h"

#include <cstddef>
#include <string>

namespace voluta::test {

// Over so many lines the extruder gives only this share of its amount; before and after them
// nothing changes. At the line: where that begins.
Mutation lowerFlow(const std::string& format, double share, std::size_t lines);

} // namespace voluta::test
