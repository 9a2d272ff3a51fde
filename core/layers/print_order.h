// The order in which the layers of several items are printed: joins their stacks into one.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace voluta::layers {

struct LayerStack;

enum class PrintOrder {
  OneAfterAnother, // all layers of an item before the next item
  ByLayer          // always the lowest layer that is not printed yet, of any item
};

// Returns one stack with the patches of all items in print order. Patch::item is the index in
// `items`; Patch::layer ascends, and layers of equal height have the same number if they are
// printed by layer. The stack of a single item is returned itself. `sequence`: the order of the
// items one after another; empty: as given. Precondition: no stack is null; there is one at least;
// a sequence has each index once.
std::shared_ptr<const LayerStack>
joinStacks(std::span<const std::shared_ptr<const LayerStack>> items, PrintOrder order,
           std::span<const std::size_t> sequence = {});

} // namespace voluta::layers
