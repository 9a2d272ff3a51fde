// Slows walls that overhang the layer below.
#pragma once

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

namespace voluta::base {
class RunContext;
}

namespace voluta::toolpath {

// Limits the speed of walls to the share of their feature's that the process states for their
// overhang (process::OverhangSpeed). The overhang is the share of the bead's width beside the layer
// below, in steps of an eighth. Level layers only; those that rest on no other layer have none.
// `stack`: the layers of the plan. Throws Cancelled.
void slowOverhangs(plan::ToolPlan& plan, const layers::LayerStack& stack,
                   const process::Tooling& tooling, const base::RunContext& ctx);

} // namespace voluta::toolpath
