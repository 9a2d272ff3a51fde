// The order in which the layers of several items are printed: joins their stacks into one.
#pragma once

#include "layers/layer_stack.h"

#include <memory>
#include <span>

namespace voluta::layers {

enum class PrintOrder {
  OneAfterAnother, // all layers of an item before the next item
  ByLayer          // the items' first layers, then their second layers, ...
};

// Returns one stack with the patches of all items in print order. Patch::item is the index in
// `items`; Patch::layer ascends. The stack of a single item is returned itself.
// Precondition: no stack is null; there is one at least.
std::shared_ptr<const LayerStack>
joinStacks(std::span<const std::shared_ptr<const LayerStack>> items, PrintOrder order);

} // namespace voluta::layers
