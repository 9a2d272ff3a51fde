// Speeds, flows and widths by feature (process/features.h).
#pragma once

#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "process/features.h"
#include "process/tooling.h"

#include <functional>
#include <vector>

namespace voluta::toolpath {

// Returns the feature that a path is, apart from the first layer.
process::Feature featureOf(const plan::ToolPath& path);

// Returns the process that covers a patch: its tool's, with the bead width of supports or of the
// first layer.
process::Process processOf(const layers::Patch& patch, const process::Tooling& tooling,
                           bool isFirstLayer);

// Widens the outermost walls to the width of their feature. `wallWidths`: per patch and vertex
// [mm], as from carriedWallWidths(). A patch whose beads have another width than its tool's process
// gets no widths.
void setWallWidths(const layers::LayerStack& stack, const process::Tooling& tooling,
                   const std::vector<char>& isFirstLayer,
                   std::vector<std::vector<double>>& wallWidths);

// Applies the speeds and flows of the processes' features to a finished plan. A flow scales the
// bead's section by its width, within the limits of the process. Speeds are the feature's, limited
// by the process's maximum flow (the bead keeps its section and is printed slower) and, at
// unsupported beads, by the bridging speed. Beads of features without settings stay as they are.
// `isFirstLayer`: per patch; `unsupported`: per waypoint. Returns whether a width has changed.
bool applyFeatures(plan::ToolPlan& plan, const process::Tooling& tooling,
                   const std::vector<char>& isFirstLayer, const std::vector<char>& unsupported);

// Multiplies the speeds of paths of the part by a factor for each path. Faster beads keep to the
// process's maximum flow and, where they are unsupported, to the bridging speed.
void scaleSpeeds(plan::ToolPlan& plan, const process::Tooling& tooling,
                 const std::function<double(const plan::ToolPath&)>& factorOf,
                 const std::vector<char>& unsupported);

} // namespace voluta::toolpath
