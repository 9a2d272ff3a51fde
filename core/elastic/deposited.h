// The figures of deposited beads under a load.
#pragma once

#include "base/run_context.h"
#include "elastic/load_case.h"
#include "elastic/principal_stress.h"
#include "plan/finding.h"
#include "plan/statistics.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

#include <optional>

namespace voluta::elastic {

struct LoadFigures {
  plan::LoadStatistics figures;
  std::optional<plan::Finding> unknown; // says why figures are unknown
};

// Returns the figures of one item's beads. Alignment is that with the strongest stress of
// `principal`, also on layers that do not contain it; beads without stress do not count. Stiffness
// and tensions are those of the cells of `load`, filled and stiffened by the beads within them, and
// by the tapes by the law of mixture; unknown (NaN) if the elasticity of a material is unknown, or
// no equilibrium is found. Supports, skirts and prime lines do not count. Throws Cancelled.
LoadFigures loadFigures(const plan::ToolPlan& plan, int item, const process::Tooling& tooling,
                        const LoadCase& load, const PrincipalStress& principal,
                        const base::RunContext& ctx);

} // namespace voluta::elastic
