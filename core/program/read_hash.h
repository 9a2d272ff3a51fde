// A number that stands for everything that a reader found in a program.
#pragma once

#include "plan/program.h"

#include <cstdint>

namespace voluta::program {

// Returns equal numbers for programs with the same motions, pauses, statements and defects, at the
// same lines; with overwhelming probability different ones otherwise.
std::uint64_t readHash(const plan::ReadProgram& program);

} // namespace voluta::program
