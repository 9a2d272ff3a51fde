// The layers of several items in one stack.
#include "layers/layer_stack.h"
#include "layers/print_order.h"

#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace voluta::layers {
namespace {

// Two patches on each of `count` layers of this height.
std::shared_ptr<const LayerStack> stackOf(int count, double heightMm = 1.0) {
  auto stack = std::make_shared<LayerStack>();
  stack->layerCount = count;
  for (int layer = 0; layer < count; ++layer)
    for (int k = 0; k < 2; ++k) {
      Patch patch;
      patch.surface.vertices.assign(3, {static_cast<double>(count), 0.0, heightMm * layer});
      patch.layer = layer;
      stack->patches.push_back(std::move(patch));
    }
  return stack;
}

std::vector<std::pair<int, int>> orderOf(const LayerStack& stack) { // item, layer
  std::vector<std::pair<int, int>> order;
  for (const Patch& patch : stack.patches)
    order.emplace_back(patch.item, patch.layer);
  return order;
}

TEST(PrintOrder, KeepsTheStackOfASingleItem) {
  const std::vector items = {stackOf(3)};
  EXPECT_EQ(joinStacks(items, PrintOrder::OneAfterAnother), items[0]);
  EXPECT_EQ(joinStacks(items, PrintOrder::ByLayer), items[0]);
}

TEST(PrintOrder, OneAfterAnotherFinishesAnItemFirst) {
  const std::vector items = {stackOf(2), stackOf(3)};
  const auto all = joinStacks(items, PrintOrder::OneAfterAnother);
  EXPECT_EQ(all->layerCount, 5);
  const std::vector<std::pair<int, int>> wanted = {{0, 0}, {0, 0}, {0, 1}, {0, 1}, {1, 2},
                                                   {1, 2}, {1, 3}, {1, 3}, {1, 4}, {1, 4}};
  EXPECT_EQ(orderOf(*all), wanted);
}

TEST(PrintOrder, ByLayerAlternates) {
  const std::vector items = {stackOf(1), stackOf(2)};
  const auto all = joinStacks(items, PrintOrder::ByLayer);
  EXPECT_EQ(all->layerCount, 2);
  const std::vector<std::pair<int, int>> wanted = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 1}};
  EXPECT_EQ(orderOf(*all), wanted);
}

TEST(PrintOrder, OneAfterAnotherFollowsASequence) {
  const std::vector items = {stackOf(2), stackOf(1)};
  const std::vector<std::size_t> sequence = {1, 0};
  const auto all = joinStacks(items, PrintOrder::OneAfterAnother, sequence);
  const std::vector<std::pair<int, int>> wanted = {{1, 0}, {1, 0}, {0, 1}, {0, 1}, {0, 2}, {0, 2}};
  EXPECT_EQ(orderOf(*all), wanted);
}

TEST(PrintOrder, ByLayerPrintsTheLowestLayerNext) {
  const std::vector items = {stackOf(2, 1.0), stackOf(3, 0.4)};
  const auto all = joinStacks(items, PrintOrder::ByLayer);
  const std::vector<std::pair<int, int>> wanted = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1},
                                                   {1, 1}, {1, 2}, {1, 2}, {0, 3}, {0, 3}};
  EXPECT_EQ(orderOf(*all), wanted);
  EXPECT_EQ(all->layerCount, 4);
}

TEST(PrintOrder, LosesNoPatch) {
  for (const PrintOrder order : {PrintOrder::OneAfterAnother, PrintOrder::ByLayer}) {
    const std::vector items = {stackOf(4), stackOf(1), stackOf(3)};
    const auto all = joinStacks(items, order);
    EXPECT_EQ(all->patches.size(), 16u);
    std::multiset<int> counts;
    int last = 0;
    for (const Patch& patch : all->patches) {
      counts.insert(patch.item);
      EXPECT_GE(patch.layer, last);
      last = patch.layer;
      EXPECT_EQ(patch.surface.vertices.front().x(),
                items[static_cast<std::size_t>(patch.item)]->layerCount);
    }
    EXPECT_EQ(counts.count(0), 8u);
    EXPECT_EQ(counts.count(1), 2u);
  }
}

} // namespace
} // namespace voluta::layers
