#include "curved/support_order.h"

#include "base/parallel.h"
#include "curved/flood.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace voluta::curved {

SupportOrder::SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
                           const base::RunContext& ctx)
    : graph_(graph), present_(present), tiesCarry_(true),
      distance_(graph.size(), std::numeric_limits<float>::infinity()),
      supports_(graph.size(), kFree), carries_(graph.size(), 0) {
  gatherRemaining();
  flood(ctx);
}

SupportOrder::SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
                           const std::vector<std::int32_t>& order, const base::RunContext& ctx)
    : graph_(graph), present_(present), tiesCarry_(false), distance_(order.begin(), order.end()),
      supports_(graph.size(), kFree), carries_(graph.size(), 0) {
  gatherRemaining();
  countAll(ctx);
}

void SupportOrder::gatherRemaining() {
  for (std::size_t v = 0; v < graph_.size(); ++v)
    if (present_[v])
      remaining_.push_back(static_cast<std::int32_t>(v));
}

void SupportOrder::flood(const base::RunContext& ctx) {
  tiesCarry_ = true;
  const auto drop = [&](auto removed) {
    remaining_.erase(std::remove_if(remaining_.begin(), remaining_.end(), removed),
                     remaining_.end());
  };
  drop([&](std::int32_t v) { return !present_[static_cast<std::size_t>(v)]; });
  chamferDistance(graph_, remaining_, present_, distance_, ctx);
  drop([&](std::int32_t v) {
    const auto x = static_cast<std::size_t>(v);
    present_[x] = std::isfinite(distance_[x]);
    return !present_[x];
  });
  countAll(ctx);
}

void SupportOrder::countAll(const base::RunContext& ctx) {
  base::parallelChunks(ctx, remaining_.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      count(static_cast<std::size_t>(remaining_[i]));
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
  supports_[v] = graph_.onPlatform[v] ? kFree : supports;
}

bool SupportOrder::reroute(std::size_t v, std::size_t limit) {
  mark_.resize(graph_.size(), 0);
  ++marked_;
  uprooted_.clear();
  lessened_.clear();
  was_.clear();
  if (!uprootAll(v, limit) || !findOtherWays()) {
    for (const std::int32_t w : lessened_)
      ++supports_[static_cast<std::size_t>(w)];
    for (std::size_t i = 0; i < was_.size(); ++i)
      distance_[static_cast<std::size_t>(uprooted_[i])] = was_[i];
    return false;
  }
  for (const std::int32_t w : uprooted_) {
    count(static_cast<std::size_t>(w));
    for (const std::int32_t u : graph_.neighbour[static_cast<std::size_t>(w)])
      if (u >= 0 && present_[static_cast<std::size_t>(u)] &&
          mark_[static_cast<std::size_t>(u)] != marked_)
        count(static_cast<std::size_t>(u));
  }
  return true;
}

bool SupportOrder::uprootAll(std::size_t from, std::size_t limit) {
  uproot(from);
  for (std::size_t i = 0; i < uprooted_.size(); ++i) {
    if (uprooted_.size() > limit)
      return false;
    uproot(static_cast<std::size_t>(uprooted_[i]));
  }
  return true;
}

void SupportOrder::uproot(std::size_t from) {
  for (std::uint32_t c = carries_[from]; c != 0; c &= c - 1) {
    const std::int32_t w = graph_.neighbour[from][static_cast<std::size_t>(std::countr_zero(c))];
    const auto x = static_cast<std::size_t>(w);
    if (!present_[x] || mark_[x] == marked_)
      continue;
    lessened_.push_back(w);
    if (--supports_[x] == 0) {
      mark_[x] = marked_;
      uprooted_.push_back(w);
    }
  }
}

bool SupportOrder::findOtherWays() {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const std::int32_t w : uprooted_) {
    was_.push_back(distance_[static_cast<std::size_t>(w)]);
    distance_[static_cast<std::size_t>(w)] = kFar;
  }
  for (const std::int32_t w : uprooted_) {
    const auto x = static_cast<std::size_t>(w);
    float by = kFar;
    for (std::size_t n = 0; n < kNeighbours; ++n)
      if (const std::int32_t u = graph_.neighbour[x][n];
          u >= 0 && present_[static_cast<std::size_t>(u)] &&
          mark_[static_cast<std::size_t>(u)] != marked_)
        by = std::min(by, distance_[static_cast<std::size_t>(u)] + kNeighbourDistance[n]);
    distance_[x] = by;
    if (by < kFar)
      open.push({by, w});
  }
  while (!open.empty()) {
    const auto [by, w] = open.top();
    open.pop();
    const auto x = static_cast<std::size_t>(w);
    if (by > distance_[x])
      continue;
    for (std::size_t n = 0; n < kNeighbours; ++n) {
      const std::int32_t u = graph_.neighbour[x][n];
      if (u < 0 || mark_[static_cast<std::size_t>(u)] != marked_)
        continue;
      const float further = by + kNeighbourDistance[n];
      if (further < distance_[static_cast<std::size_t>(u)]) {
        distance_[static_cast<std::size_t>(u)] = further;
        open.push({further, u});
      }
    }
  }
  return std::all_of(uprooted_.begin(), uprooted_.end(),
                     [&](std::int32_t w) { return distance_[static_cast<std::size_t>(w)] < kFar; });
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
