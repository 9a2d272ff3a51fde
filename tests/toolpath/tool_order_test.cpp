// The order of tools within layers: the fewest changes, found by trying all orders.
#include "toolpath/order/tool_order.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace voluta::toolpath {
namespace {

using Layers = std::vector<std::vector<int>>;

// The fewest changes from layer `at` on, with that tool mounted, by trying all orders.
std::size_t fewest(const Layers& layers, std::size_t at, int mounted) {
  if (at == layers.size())
    return 0;
  std::vector<int> tools = layers[at];
  std::ranges::sort(tools);
  std::size_t best = std::numeric_limits<std::size_t>::max();
  do {
    const std::size_t here = toolChanges(Layers{tools}, mounted);
    const int last = tools.empty() ? mounted : tools.back();
    best = std::min(best, here + fewest(layers, at + 1, last));
  } while (std::ranges::next_permutation(tools).found);
  return best;
}

TEST(ToolOrder, OneToolNeedsNoChange) {
  const Layers layers(10, {0});
  EXPECT_EQ(toolOrder(layers), layers);
  EXPECT_EQ(toolChanges(toolOrder(layers)), 0u);
}

TEST(ToolOrder, TwoToolsChangeOnceALayer) {
  const Layers order = toolOrder(Layers(10, {0, 1}));
  EXPECT_EQ(toolChanges(order), 10u);
  EXPECT_EQ(order[0], (std::vector<int>{0, 1}));
  EXPECT_EQ(order[1], (std::vector<int>{1, 0}));
}

TEST(ToolOrder, ALayerEndsWithTheToolThatTheNextOneNeeds) {
  const Layers order = toolOrder(Layers{{0, 1, 2}, {1}, {}, {1, 2}, {2}});
  EXPECT_EQ(order[0], (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(order[3], (std::vector<int>{1, 2}));
  EXPECT_EQ(toolChanges(order), 3u);
}

TEST(ToolOrder, NeedsTheFewestChangesOfAllOrders) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    Layers layers(1 + random() % 5);
    for (std::vector<int>& tools : layers)
      for (int tool = 0; tool < 4; ++tool)
        if (random() % 2 == 0)
          tools.push_back(tool);
    const int mounted = static_cast<int>(random() % 4);
    const Layers order = toolOrder(layers, mounted);
    EXPECT_EQ(toolChanges(order, mounted), fewest(layers, 0, mounted));
    for (std::size_t l = 0; l < layers.size(); ++l)
      EXPECT_TRUE(std::ranges::is_permutation(order[l], layers[l]));
  }
}

} // namespace
} // namespace voluta::toolpath
