// Support in closed hollows of a part, from which nobody can remove it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"

#include <optional>

namespace voluta::plan {
struct ToolPlan;
}

namespace voluta::layers {

// Returns the finding "walledSupport" with the volume of support in all closed hollows, at the one
// with most; nullopt if there is none. `part`: closed, its hollows are shells that face inwards.
std::optional<plan::Finding> walledSupport(const LayerStack& stack,
                                           const geometry::TriangleMesh& part);
// The same for support beads below beads of the part's own layers
// (toolpath/unsupported/rim_supports.h). `plan`: of the layers in `stack`.
std::optional<plan::Finding> walledSupport(const plan::ToolPlan& plan, const LayerStack& stack,
                                           const geometry::TriangleMesh& part);

} // namespace voluta::layers
