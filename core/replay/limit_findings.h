// Findings about limits of the arm and of the extruder.
#pragma once

#include "plan/finding.h"
#include "replay/executed_path.h"
#include "robot/cell.h"

namespace voluta::replay {

// Returns the violation as a finding without place and time.
plan::Finding limitFinding(const LimitViolation& violation, const robot::Cell& cell);

} // namespace voluta::replay
