// Divides a straight motion into pieces, for controllers that move an arm by its joints only.
#pragma once

#include "program/program_input.h"

#include <cstddef>
#include <vector>

namespace voluta::program {

// If joints at constant speeds would lead the nozzle further than `maxMm` from its straight path
// on the part to `point` (> 0), returns the joints at equal shares of that path, with evenly
// interpolated orientation and without the ends. Empty if the deviation is small enough, or if the
// arm cannot follow the path in its IK branch.
std::vector<robot::JointVector> straightPieces(const ProgramInput& input, std::size_t point,
                                               double maxMm);

} // namespace voluta::program
