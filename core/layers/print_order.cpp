#include "layers/print_order.h"

#include "base/error.h"
#include "layers/layer_stack.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace voluta::layers {

namespace {
// Heights closer than this are those of one layer.
constexpr double kSameHeightMm = 0.01;

// Joins the patches of several items.
class StackJoiner {
public:
  explicit StackJoiner(std::span<const std::shared_ptr<const LayerStack>> items)
      : items_(items), next_(items.size()) {}

  LayerStack oneAfterAnother(std::span<const std::size_t> sequence) {
    for (const std::size_t i : sequence) {
      const int firstLayer = all_.layerCount;
      while (hasNext(i))
        add(i, firstLayer + nextPatch(i).layer);
      all_.layerCount = firstLayer + items_[i]->layerCount;
    }
    return withPockets();
  }

  LayerStack byLayer() {
    std::vector<std::size_t> lowest;
    while (!(lowest = itemsWithLowestLayer()).empty()) {
      for (const std::size_t i : lowest)
        addLayer(i, all_.layerCount);
      ++all_.layerCount;
    }
    return withPockets();
  }

private:
  LayerStack withPockets() {
    for (std::size_t i = 0; i < items_.size(); ++i)
      for (Pocket pocket : items_[i]->pockets) {
        pocket.item = static_cast<int>(i);
        pocket.layer = joinedLayer_.at({i, pocket.layer});
        all_.pockets.push_back(pocket);
      }
    std::ranges::stable_sort(all_.pockets, {}, &Pocket::layer);
    return std::move(all_);
  }

  bool hasNext(std::size_t item) const { return next_[item] < items_[item]->patches.size(); }
  const Patch& nextPatch(std::size_t item) const { return items_[item]->patches[next_[item]]; }

  void add(std::size_t item, int layer) {
    Patch patch = nextPatch(item);
    joinedLayer_[{item, patch.layer}] = layer;
    patch.item = static_cast<int>(item);
    patch.layer = layer;
    all_.patches.push_back(std::move(patch));
    ++next_[item];
  }

  void addLayer(std::size_t item, int layer) {
    const int own = nextPatch(item).layer;
    while (hasNext(item) && nextPatch(item).layer == own)
      add(item, layer);
  }

  // Returns the mean height of the vertices of the item's next layer.
  double nextHeightMm(std::size_t item) const {
    const std::vector<Patch>& patches = items_[item]->patches;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t p = next_[item];
         p < patches.size() && patches[p].layer == nextPatch(item).layer; ++p)
      for (const Eigen::Vector3d& v : patches[p].surface.vertices) {
        sum += v.z();
        ++count;
      }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  std::vector<std::size_t> itemsWithLowestLayer() const {
    std::vector<double> height(items_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (hasNext(i))
        height[i] = nextHeightMm(i);
    const double lowest = std::ranges::min(height);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (hasNext(i) && height[i] <= lowest + kSameHeightMm)
        found.push_back(i);
    return found;
  }

  std::span<const std::shared_ptr<const LayerStack>> items_;
  std::vector<std::size_t> next_; // first patch of each item that is not joined yet
  std::map<std::pair<std::size_t, int>, int> joinedLayer_; // by item and its own layer
  LayerStack all_;
};
} // namespace

std::shared_ptr<const LayerStack>
joinStacks(std::span<const std::shared_ptr<const LayerStack>> items, PrintOrder order,
           std::span<const std::size_t> sequence) {
  base::require(!items.empty(), "a job has an item");
  if (items.size() == 1)
    return items.front();
  StackJoiner joiner(items);
  if (order == PrintOrder::ByLayer)
    return kept(joiner.byLayer());
  std::vector<std::size_t> asGiven(items.size());
  std::iota(asGiven.begin(), asGiven.end(), std::size_t{0});
  base::require(sequence.empty() || sequence.size() == items.size(), "a sequence of all items");
  return kept(joiner.oneAfterAnother(sequence.empty() ? asGiven : sequence));
}

} // namespace voluta::layers
