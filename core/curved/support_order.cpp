#include "curved/support_order.h"

#include "base/parallel.h"
#include "curved/flood.h"

#include <bit>

namespace voluta::curved {

SupportOrder::SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
                           const base::RunContext& ctx)
    : graph_(graph), present_(present), tiesCarry_(true) {
  flood(ctx);
}

SupportOrder::SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
                           const std::vector<std::int32_t>& order, const base::RunContext& ctx)
    : graph_(graph), present_(present), tiesCarry_(false), distance_(order.begin(), order.end()) {
  countAll(ctx);
}

void SupportOrder::flood(const base::RunContext& ctx) {
  tiesCarry_ = true;
  Flood reached = curved::flood(graph_, present_, {}, 1.0f, ctx);
  distance_ = std::move(reached.value);
  for (std::size_t v = 0; v < graph_.size(); ++v)
    present_[v] = reached.order[v] >= 0;
  countAll(ctx);
}

void SupportOrder::countAll(const base::RunContext& ctx) {
  supports_.assign(graph_.size(), kFree);
  carries_.assign(graph_.size(), 0);
  base::parallelChunks(ctx, graph_.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (present_[v])
        count(v);
  });
}

void SupportOrder::count(std::size_t v) {
  std::uint8_t supports = 0;
  std::uint32_t carries = 0;
  for (std::size_t n = 0; n < kNeighbours; ++n) {
    const std::int32_t w = graph_.neighbour[v][n];
    if (w < 0 || !present_[static_cast<std::size_t>(w)])
      continue;
    const auto x = static_cast<std::size_t>(w);
    if (rests(x, v))
      ++supports;
    else if (rests(v, x) && !graph_.onPlatform[x])
      carries |= 1u << n;
  }
  carries_[v] = carries;
  if (!graph_.onPlatform[v])
    supports_[v] = supports;
}

bool SupportOrder::allows(std::size_t v) const {
  for (std::uint32_t c = carries_[v]; c != 0; c &= c - 1) {
    const std::int32_t w = graph_.neighbour[v][static_cast<std::size_t>(std::countr_zero(c))];
    if (supports_[static_cast<std::size_t>(w)] < 2)
      return false;
  }
  return true;
}

void SupportOrder::change(std::size_t v, int by) {
  for (std::uint32_t c = carries_[v]; c != 0; c &= c - 1) {
    const std::int32_t w = graph_.neighbour[v][static_cast<std::size_t>(std::countr_zero(c))];
    supports_[static_cast<std::size_t>(w)] =
        static_cast<std::uint8_t>(supports_[static_cast<std::size_t>(w)] + by);
  }
}

} // namespace voluta::curved
