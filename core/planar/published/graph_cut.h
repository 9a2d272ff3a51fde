// Labels of neighbours that agree where it costs much that they do not.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace voluta::planar {

struct LabelEdge {
  std::array<std::size_t, 2> nodes{};
  double cost = 0.0; // >= 0, where the labels of its nodes differ
};

// Minimises the sum of labelCosts[label][node] over all nodes and of the costs of edges whose nodes
// differ, by alpha expansion (Boykov, Veksler, Zabih 2001) from the cheapest labels. Returns a
// label a node. Precondition (Error{Internal}): a label at least, as many costs for each.
std::vector<std::size_t> graphCut(const std::vector<std::vector<double>>& labelCosts,
                                  const std::vector<LabelEdge>& edges);

} // namespace voluta::planar
