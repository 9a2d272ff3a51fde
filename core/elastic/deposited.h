// The figures of deposited beads under a load.
#pragma once

#include "base/run_context.h"
#include "elastic/load_case.h"
#include "elastic/principal_stress.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

namespace voluta::elastic {

// Returns the figures of one item's beads. Alignment is that with the strongest stress of
// `principal`, also on layers that do not contain it. Stiffness and tensions are those of the cells
// of `load`, filled and stiffened by the beads within them, and by the tapes by the law of mixture;
// 0 if the elasticity of a material is unknown. Supports, skirts and prime lines do not count.
// Throws as solved().
plan::LoadStatistics loadFigures(const plan::ToolPlan& plan, int item,
                                 const process::Tooling& tooling, const LoadCase& load,
                                 const PrincipalStress& principal, const base::RunContext& ctx);

} // namespace voluta::elastic
