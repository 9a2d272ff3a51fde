// Labelling of a graph by alpha expansion.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::planar {

struct LabelEdge {
  std::array<std::size_t, 2> nodes{};
  double cost = 0.0; // >= 0, paid if the labels of its nodes differ
};

// Minimises the sum of labelCosts[label][node] over all nodes and of the costs of edges whose nodes
// differ, by alpha expansion (Boykov, Veksler, Zabih 2001), starting from the cheapest labels.
// Returns one label per node. Precondition (Error{Internal}): at least one label, and the same
// number of costs for each.
std::vector<std::size_t> graphCut(const std::vector<std::vector<double>>& labelCosts,
                                  const std::vector<LabelEdge>& edges);

} // namespace voluta::planar
