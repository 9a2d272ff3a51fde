// The seams of all closed walls, layer after layer.
#pragma once

#include "layers/layer_stack.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/order/seam.h"
#include "toolpath/order/seam_places.h"

#include <memory>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// What the regions of each item say about seams, by Patch::item; fewer, or null: nothing.
using SeamsOfItems = std::vector<std::shared_ptr<const SeamPlaces>>;

// Returns per patch and bead the bead begun at its seam; nullopt if it may begin anywhere: open
// beads, infill, supports, and all if the kind has no places; unless a region says where a closed
// bead of the part begins. Preconditions: one cover a patch; print order.
std::vector<std::vector<std::optional<Bead>>> placeSeams(const layers::LayerStack& stack,
                                                         const std::vector<PatchCover>& covers,
                                                         const SeamKind& kind,
                                                         const SeamsOfItems& ofRegions = {});

} // namespace voluta::toolpath
