#include "curved/greedy_growth.h"

#include "curved/convex_front.h"

#include <utility>

namespace voluta::curved {

GreedyGrowth greedyGrowth(const VoxelGraph& graph, const base::RunContext& ctx) {
  GreedyGrowth out;
  out.rank.assign(graph.size(), 0);
  ConvexFront front(graph);
  std::vector<std::int32_t> layer, next;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.onPlatform[v])
      layer.push_back(static_cast<std::int32_t>(v));
  std::size_t laid = 0, hint = 0;
  while (!layer.empty()) {
    ++out.ranks;
    for (const std::int32_t v : layer) {
      out.rank[static_cast<std::size_t>(v)] = out.ranks;
      front.insert(static_cast<std::size_t>(v));
    }
    front.rebuild();
    laid += layer.size();
    ctx.report(static_cast<double>(laid) / static_cast<double>(graph.size()), "growth");
    next.clear();
    for (const std::int32_t v : layer)
      for (const std::int32_t w : graph.neighbour[static_cast<std::size_t>(v)]) {
        if (w < 0)
          continue;
        const auto x = static_cast<std::size_t>(w);
        if (out.rank[x] == 0 && !front.deeperThan(x, 0.0, hint)) {
          out.rank[x] = -1; // in the next layer already
          next.push_back(w);
        }
      }
    std::swap(layer, next);
  }
  return out;
}

} // namespace voluta::curved
