#include "planar/published/graph_cut.h"

#include "base/error.h"

#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <utility>

namespace voluta::planar {

std::vector<std::size_t> graphCut(const std::vector<std::vector<double>>& labelCosts,
                                  const std::vector<LabelEdge>& edges) {
  base::require(!labelCosts.empty(), "graphCut: a label at least");
  const std::size_t nodes = labelCosts.front().size();
  for (const auto& costs : labelCosts)
    base::require(costs.size() == nodes, "graphCut: as many costs for each label");
  std::vector<std::size_t> labels(nodes, 0);
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t l = 1; l < labelCosts.size(); ++l)
      if (labelCosts[l][n] < labelCosts[labels[n]][n])
        labels[n] = l;
  if (labelCosts.size() == 1 || nodes == 0)
    return labels;
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<double> costs;
  for (const LabelEdge& e : edges) {
    ends.emplace_back(e.nodes[0], e.nodes[1]);
    costs.push_back(e.cost);
  }
  CGAL::alpha_expansion_graphcut(ends, costs, labelCosts, labels);
  return labels;
}

} // namespace voluta::planar
