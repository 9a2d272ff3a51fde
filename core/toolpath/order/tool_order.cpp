#include "toolpath/order/tool_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace voluta::toolpath {

namespace {
// A layer's changes depend only on its first and last tool: for each possible last tool, the best
// first one.
struct Choice {
  int last = 0, first = 0;
  std::size_t changes = 0; // up to the end of the layer
  std::size_t before = 0;  // index of the choice in the layer before
};

std::vector<Choice> choicesOf(const std::vector<int>& tools, const std::vector<Choice>& before) {
  std::vector<Choice> choices;
  for (const int last : tools) {
    Choice best{.last = last, .changes = std::numeric_limits<std::size_t>::max()};
    for (const int begin : tools) {
      if (begin == last && tools.size() > 1)
        continue;
      for (std::size_t b = 0; b < before.size(); ++b) {
        const std::size_t changes =
            before[b].changes + (before[b].last != begin ? 1 : 0) + tools.size() - 1;
        if (changes < best.changes) {
          best.first = begin;
          best.changes = changes;
          best.before = b;
        }
      }
    }
    choices.push_back(best);
  }
  return choices;
}
} // namespace

std::vector<std::vector<int>> toolOrder(std::span<const std::vector<int>> layers, int first) {
  std::vector<std::vector<Choice>> choices; // Of the layers that are not empty
  std::vector<Choice> before{{.last = first, .first = first}};
  for (const std::vector<int>& tools : layers)
    if (!tools.empty())
      before = choices.emplace_back(choicesOf(tools, before));

  std::vector<std::vector<int>> orders(layers.begin(), layers.end());
  std::size_t chosen = 0;
  if (!choices.empty())
    chosen = static_cast<std::size_t>(
        std::ranges::min_element(choices.back(), {}, &Choice::changes) - choices.back().begin());
  for (std::size_t l = layers.size(), c = choices.size(); l-- > 0;) {
    if (orders[l].empty())
      continue;
    const Choice& choice = choices[--c][chosen];
    std::ranges::sort(orders[l], {}, [&](int tool) {
      return std::pair(tool == choice.first ? 0 : tool == choice.last ? 2 : 1, tool);
    });
    chosen = choice.before;
  }
  return orders;
}

std::size_t toolChanges(std::span<const std::vector<int>> orders, int first) {
  std::size_t changes = 0;
  for (const std::vector<int>& tools : orders)
    for (const int tool : tools) {
      changes += tool != first ? 1 : 0;
      first = tool;
    }
  return changes;
}

} // namespace voluta::toolpath
