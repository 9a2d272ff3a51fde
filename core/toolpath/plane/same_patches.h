// Layers of the same shape, as in a prism.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// A patch has the shape of an earlier one, moved along the build direction.
struct SameShape {
  std::size_t patch = 0; // the first of this shape; the patch itself if none is before it
  Eigen::Vector3d shiftMm = Eigen::Vector3d::Zero(); // from there
};

// Returns for each patch the first one that is the same region of another plane (within 0.2 um),
// with the same thickness, directions, group and tool, and the same `choices[i]`. Patches that are
// not even planes (PlanePatch::isEven) are like no other. Precondition: choices per patch.
std::vector<SameShape> sameShapes(const std::vector<const layers::Patch*>& patches,
                                  const std::vector<std::vector<double>>& choices,
                                  const base::RunContext& ctx);

} // namespace voluta::toolpath
