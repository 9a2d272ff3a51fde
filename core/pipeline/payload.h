// The mass that the robot carries against its rating.
#pragma once

#include "plan/finding.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::pipeline {

// Returns a finding if the flange carries more than 90 % of the robot's payload once everything is
// printed: the tool, or the plate with the printed material. It blocks above the payload. nullopt
// also if the payload is unknown.
std::optional<plan::Finding> overload(const robot::Cell& cell, double materialG);

} // namespace voluta::pipeline
