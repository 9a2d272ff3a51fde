// Predicts from the tool-paths a failure that the replay of any program would report.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/process.h"

#include <optional>

namespace voluta::pipeline {

// Returns the finding Mass if the beads of the part contain so much or so little material that no
// program of them can have a mass ratio within `tolerance` of 1; else nullopt. `part`: the
// closed mesh that replay uses as the reference.
std::optional<plan::Finding> massOutOfReach(const plan::ToolPlan& toolPlan,
                                            const geometry::TriangleMesh& part,
                                            const process::Process& process, double tolerance);

} // namespace voluta::pipeline
