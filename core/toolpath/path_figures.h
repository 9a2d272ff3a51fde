// Figures that follow from the finished paths of a plan, planned or given.
#pragma once

#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

#include <cstddef>

namespace voluta::toolpath {

// Sets paths, starts, waypoints, length, travel, material, tapes (number, length, mass), shots, and
// `items` if there is more than one item. The length includes waste, the material does not.
// Preconditions: each path's item is less than `items`; each path's tool is one of `tooling`.
void setPathFigures(const plan::ToolPlan& plan, std::size_t items, const process::Tooling& tooling,
                    plan::ToolpathStatistics& statistics);

// Returns the greatest angle between the directions of successive waypoints of a path [deg].
double maxRotationDeg(const plan::ToolPlan& plan);

} // namespace voluta::toolpath
