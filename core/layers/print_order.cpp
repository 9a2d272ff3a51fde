#include "layers/print_order.h"

#include "base/error.h"

#include <algorithm>

namespace voluta::layers {

std::shared_ptr<const LayerStack>
joinStacks(std::span<const std::shared_ptr<const LayerStack>> items, PrintOrder order) {
  base::require(!items.empty(), "a job has an item");
  if (items.size() == 1)
    return items.front();
  LayerStack all;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const int firstLayer = order == PrintOrder::OneAfterAnother ? all.layerCount : 0;
    for (Patch patch : items[i]->patches) {
      patch.item = static_cast<int>(i);
      patch.layer += firstLayer;
      all.patches.push_back(std::move(patch));
    }
    all.layerCount = std::max(all.layerCount, firstLayer + items[i]->layerCount);
  }
  if (order == PrintOrder::ByLayer)
    std::ranges::stable_sort(all.patches, {}, &Patch::layer);
  return kept(std::move(all));
}

} // namespace voluta::layers
