#include "curved/grow.h"

#include <algorithm>

namespace voluta::curved {

Growth grow(const VoxelGraph& graph, const GrowthScheme& scheme, const ForwardOptions& forward,
            const base::RunContext& ctx, const process::HeadShape* head) {
  Growth out = scheme.row().grow({graph, forward, head}, ctx);
  if (out.scheme.empty())
    out.scheme = scheme.id();
  out.printed = static_cast<std::size_t>(
      std::count_if(out.rank.begin(), out.rank.end(), [](std::int32_t r) { return r > 0; }));
  return out;
}

} // namespace voluta::curved
