// The order of the kinds of beads within a patch.
#pragma once

#include "plan/tool_plan.h"
#include "toolpath/coverage/bead.h"

#include <limits>

namespace voluta::toolpath {

// Returns the bead's turn: within a patch, beads of a lower turn are printed first. The outermost
// wall comes first, so that nothing displaces it; the inner walls come last, from inside outwards,
// so that they fill what infill and gap fill leave.
constexpr int printOrder(const Bead& bead) {
  switch (bead.kind) {
  case plan::PathKind::Wall:
    return bead.ring == 0 ? -1 : std::numeric_limits<int>::max() - bead.ring;
  case plan::PathKind::Infill:
  case plan::PathKind::Bridge:
    return 0;
  default:
    return 1;
  }
}

} // namespace voluta::toolpath
