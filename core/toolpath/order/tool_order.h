// The order of the tools within layers that needs the fewest tool changes.
#pragma once

#include <span>
#include <vector>

namespace voluta::toolpath {

// Returns, for each layer, its tools in the order in which they print: of all orders that keep the
// order of the layers, one with the fewest changes from tool to tool. Tool `first` is mounted
// before the first layer. `layers`: the tools of each layer, each once, in any order; may be empty.
std::vector<std::vector<int>> toolOrder(std::span<const std::vector<int>> layers, int first = 0);

// Returns the number of tool changes of these orders.
std::size_t toolChanges(std::span<const std::vector<int>> orders, int first = 0);

} // namespace voluta::toolpath
