// Divides a joint motion into straight pieces, for dialects that support straight motions only.
#pragma once

#include "program/common/motion_targets.h"
#include "program/program_input.h"

#include <cstddef>

namespace voluta::program {

// Returns the number of straight pieces, of equal duration, that stay within 0.2 mm and half a
// degree of the nozzle's path under the joint motion to `point` (> 0); at most 128. 1: it is
// straight anyway.
int jointPieces(const ProgramInput& input, std::size_t point);

// Returns the target of the arm on that path, t from 0 to 1.
MotionTarget jointPiece(const ProgramInput& input, std::size_t point, double t);

} // namespace voluta::program
