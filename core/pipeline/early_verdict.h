// What a replay of a plan's program is bound to find, known before there is one.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/process.h"

#include <optional>

namespace voluta::pipeline {

// Returns the finding where the material of the part's beads is so much or so little that no
// program of theirs has a mass ratio that passes (replay::ReplayThresholds). `part`: what a replay
// weighs it against, closed.
std::optional<plan::Finding> massOutOfReach(const plan::ToolPlan& toolPlan,
                                            const geometry::TriangleMesh& part,
                                            const process::Process& process);

} // namespace voluta::pipeline
