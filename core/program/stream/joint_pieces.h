// A joint motion as straight pieces, for dialects that can only go straight.
#pragma once

#include "program/common/motion_targets.h"
#include "program/program_input.h"

#include <cstddef>

namespace voluta::program {

// How many straight pieces, equal in time, keep within 0.2 mm and half a degree of the nozzle's way
// to `point` (> 0) by joints; at most 128. 1: it is straight by itself.
int jointPieces(const ProgramInput& input, std::size_t point);

// Where the arm is on that way, t from 0 to 1.
MotionTarget jointPiece(const ProgramInput& input, std::size_t point, double t);

} // namespace voluta::program
