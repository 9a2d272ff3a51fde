// One head that contains the heads of several tools.
#pragma once

#include "process/process.h"

#include <span>
#include <vector>

namespace voluta::process {

// Returns a head that contains all of them, with their tips in one place; at each height of a
// section it is as wide as the widest. A single head is returned unchanged. Precondition: none is
// empty.
HeadShape joinedHeads(std::span<const HeadShape> heads);

} // namespace voluta::process
