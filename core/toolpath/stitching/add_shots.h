// Adds the shots that fill a part's pockets (Castelli 6.3), each as soon as the layer that ends at
// the pocket's top is finished.
#pragma once

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "toolpath/options.h"

#include <span>
#include <vector>

namespace voluta::toolpath {

// Adds a shot for each pocket behind the last bead of its item's layer, in the order of least
// travel. Its waypoints are above the pocket, at depthMm below its top, and above it again; the
// pocket's volume is multiplied by 1 + excess.
void addShots(plan::ToolPlan& plan, std::span<const layers::Pocket> pockets,
              const process::Tooling& tooling, const StitchOptions& options);

// Clears the marks of beads that lie on a pocket, which a shot has filled before them.
void acceptBeadsOnPockets(const plan::ToolPlan& plan, std::span<const layers::Pocket> pockets,
                          std::vector<char>& unsupported);

} // namespace voluta::toolpath
