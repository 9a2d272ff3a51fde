// The seams of all closed walls, layer after layer.
#pragma once

#include "layers/layer_stack.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/order/seam.h"

#include <optional>
#include <vector>

namespace voluta::toolpath {

// Returns per patch and bead the bead begun at its seam; nullopt if it may begin anywhere: open
// beads, infill, supports, and all if the kind has no places. Preconditions: one cover a patch;
// print order.
std::vector<std::vector<std::optional<Bead>>> placeSeams(const layers::LayerStack& stack,
                                                         const std::vector<PatchCover>& covers,
                                                         const SeamKind& kind);

} // namespace voluta::toolpath
