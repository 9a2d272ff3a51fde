// Part cooling: how fast the fan runs while a bead is printed.
#pragma once

#include "plan/tool_plan.h"
#include "process/material.h"

namespace voluta::process {

// Returns the fan's share of its full speed, 0..1: off in the first layer, so that the part sticks;
// later the material's, and on bridges that for bridges if the material has one.
double fanShare(const Material& material, const plan::ToolPath& path);

// Shares that differ by less are the same: programs write them in steps of 1/255.
inline constexpr double kSameFan = 0.01;

} // namespace voluta::process
