#include "curved/peeling_field.h"

#include "base/error.h"
#include "curved/convex_front.h"

#include <cmath>

namespace voluta::curved {

std::vector<std::int32_t> peelingField(const VoxelGraph& graph, const base::RunContext& ctx) {
  ConvexFront front(graph);
  for (std::size_t v = 0; v < graph.size(); ++v)
    front.insert(v);
  std::vector<std::int32_t> peeled(graph.size(), 0), sheet;
  for (std::int32_t round = 1; front.count() > 0; ++round) {
    front.rebuild();
    front.nearSurface(0.0, sheet);
    base::require(!sheet.empty(), "peelingField: a platform with an area");
    for (const std::int32_t v : sheet) {
      peeled[static_cast<std::size_t>(v)] = round;
      front.remove(static_cast<std::size_t>(v));
    }
    ctx.report(1.0 - static_cast<double>(front.count()) / static_cast<double>(graph.size()),
               "peeling"_text);
  }
  return peeled;
}

std::vector<std::int32_t> peelingField(const Decomposition& d, const base::RunContext& ctx) {
  std::vector<std::uint8_t> part(d.rank.size(), 0);
  for (std::size_t c = 0; c < part.size(); ++c)
    part[c] = d.rank[c] != 0 && (d.support.empty() || !d.support[c]);
  const int plateLayer = static_cast<int>(std::lround(-d.grid.origin.z() / d.grid.pitch));
  const VoxelGraph graph = voxelGraph(d.grid, part, plateLayer, d.platform);
  const std::vector<std::int32_t> peeled = peelingField(graph, ctx);
  std::vector<std::int32_t> ofCell(part.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto [i, j, k] = graph.cell[v];
    ofCell[d.grid.index(i, j, k)] = peeled[v];
  }
  return ofCell;
}

} // namespace voluta::curved
