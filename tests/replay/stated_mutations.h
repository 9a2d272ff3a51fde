// Damage to statements beside the motions: heat, modes, the operator's stop, the full flow, waits,
// velocities of PVT, posture flags, names of functions.
#pragma once

#include "replay/mutations.h"

#include <string>
#include <vector>

namespace voluta::test {

std::vector<Mutation> statedMutations(const std::string& format);

} // namespace voluta::test
