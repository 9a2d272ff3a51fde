// A straight motion in pieces for what moves an arm by its joints only.
#pragma once

#include "program/program_input.h"

#include <cstddef>
#include <vector>

namespace voluta::program {

// Where joints at steady speeds would lead the nozzle further than `mostMm` from its straight way
// on the part to `point` (> 0): the joints at equal shares of it on that way, turned evenly,
// without its ends. Empty: it is near enough, or the arm cannot go there as it stands.
std::vector<robot::JointVector> straightPieces(const ProgramInput& input, std::size_t point,
                                               double mostMm);

} // namespace voluta::program
