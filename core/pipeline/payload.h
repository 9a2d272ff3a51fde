// The mass that the robot carries against its rating.
#pragma once

#include "plan/finding.h"
#include "robot/cell.h"

#include <optional>

namespace voluta::pipeline {

struct PlanResult;

// Returns a finding if the flange carries more than 90 % of the robot's payload once everything is
// printed: the tool, or the plate with the printed material. It blocks above the payload. nullopt
// also if the payload is unknown.
std::optional<plan::Finding> overload(const robot::Cell& cell, double materialG);

// Returns the mass [kg] of the placed parts of a result as solids, each of the material of the tool
// that prints it. Parts that are not placed yet have none.
double solidKg(const PlanResult& result);

} // namespace voluta::pipeline
