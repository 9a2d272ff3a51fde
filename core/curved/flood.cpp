#include "curved/flood.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

struct Front {
  float value;
  std::int32_t voxel;
  // Orders by least value, then by least index, so that the order is unique.
  bool operator<(const Front& other) const {
    return value != other.value ? value > other.value : voxel > other.voxel;
  }
};

// A priority queue for values >= 0 that rarely decrease: one small heap per span of values.
class FrontQueue {
public:
  bool empty() const { return count_ == 0; }

  void push(const Front& front) {
    const auto at = static_cast<std::size_t>(front.value / kSpan);
    if (at >= spans_.size())
      spans_.resize(at + at / 2 + 1);
    spans_[at].push_back(front);
    if (at <= current_) {
      if (at < current_) {
        current_ = at;
        std::make_heap(spans_[at].begin(), spans_[at].end());
      } else {
        std::push_heap(spans_[at].begin(), spans_[at].end());
      }
    }
    ++count_;
  }

  Front pop() {
    while (spans_[current_].empty()) {
      ++current_;
      std::make_heap(spans_[current_].begin(), spans_[current_].end());
    }
    std::vector<Front>& span = spans_[current_];
    std::pop_heap(span.begin(), span.end());
    const Front top = span.back();
    span.pop_back();
    --count_;
    return top;
  }

private:
  static constexpr float kSpan = 0.25f; // Cells
  std::vector<std::vector<Front>> spans_{1};
  std::size_t current_ = 0, count_ = 0;
};

// First-order solution of |grad T| = 1 from the smallest known values along each axis.
float eikonal(std::array<float, 3> axisMin) {
  std::sort(axisMin.begin(), axisMin.end());
  float solution = axisMin[0] + 1.0f;
  for (int dim = 2; dim <= 3 && solution > axisMin[static_cast<std::size_t>(dim - 1)]; ++dim) {
    float sum = 0.0f, squares = 0.0f;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
      sum += axisMin[a];
      squares += axisMin[a] * axisMin[a];
    }
    const auto n = static_cast<float>(dim);
    const float discriminant = sum * sum - n * (squares - 1.0f);
    if (discriminant < 0.0f)
      break;
    solution = (sum + std::sqrt(discriminant)) / n;
  }
  return solution;
}

} // namespace

Flood flood(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
            const base::RunContext& ctx) {
  const auto usable = [&](std::size_t v) { return use.empty() || use[v]; };
  Flood out;
  out.value.assign(graph.size(), kFar);
  out.order.assign(graph.size(), -1);
  FrontQueue queue;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.onPlatform[v] && usable(v)) {
      out.value[v] = 0.5f;
      queue.push({0.5f, static_cast<std::int32_t>(v)});
    }
  while (!queue.empty()) {
    const Front top = queue.pop();
    const auto v = static_cast<std::size_t>(top.voxel);
    if (out.order[v] >= 0)
      continue;
    out.order[v] = static_cast<std::int32_t>(out.reached++);
    if (out.reached % 4096 == 0)
      ctx.checkpoint();
    for (std::size_t s = 0; s < kNeighbours; ++s) {
      const std::int32_t w = graph.neighbour[v][s];
      if (w < 0 || !usable(static_cast<std::size_t>(w)))
        continue;
      const float by = top.value + kNeighbourDistance[s];
      if (by < out.value[static_cast<std::size_t>(w)]) {
        out.value[static_cast<std::size_t>(w)] = by;
        queue.push({by, w});
      }
    }
  }
  return out;
}

namespace {

class PitFilling {
public:
  PitFilling(const VoxelGraph& graph, const std::vector<float>& field, float slope)
      : graph_(graph), field_(field), slope_(slope), value_(graph.size(), kFar),
        known_(graph.size(), 0) {}

  std::vector<float> run(const base::RunContext& ctx) {
    ctx.checkpoint();
    keepWhatRises();
    std::vector<std::int32_t> rest;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (!known_[v])
        rest.push_back(static_cast<std::int32_t>(v));
    raise(rest, 0, 6, ctx);
    for (std::size_t before = 0;;) {
      std::erase_if(rest, [&](std::int32_t v) { return known_[static_cast<std::size_t>(v)] != 0; });
      if (rest.size() == before)
        break;
      before = rest.size();
      raise(rest, 6, kNeighbours, ctx);
    }
    return std::move(value_);
  }

private:
  // Most of a field has no pits. Voxels that rise from the platform steeply enough, face by face,
  // keep their values, whatever the order of the steps.
  void keepWhatRises() {
    std::vector<std::int32_t> open;
    const auto keep = [&](std::size_t v, float value) {
      value_[v] = value;
      known_[v] = 1;
      open.push_back(static_cast<std::int32_t>(v));
    };
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (graph_.onPlatform[v])
        keep(v, std::max(field_[v], 0.5f * slope_));
    while (!open.empty()) {
      const auto v = static_cast<std::size_t>(open.back());
      open.pop_back();
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph_.neighbour[v][s]; w >= 0)
          if (const auto x = static_cast<std::size_t>(w);
              !known_[x] && field_[x] >= value_[v] + slope_)
            keep(x, field_[x]);
    }
  }

  // Raises the voxels of `rest`, all of them unknown, that steps [first, end) reach from known
  // voxels, and those that faces reach from there.
  void raise(const std::vector<std::int32_t>& rest, std::size_t first, std::size_t end,
             const base::RunContext& ctx) {
    for (const std::int32_t v : rest) {
      const auto x = static_cast<std::size_t>(v);
      for (std::size_t s = first; s < end; ++s)
        if (const std::int32_t u = graph_.neighbour[x][s];
            u >= 0 && known_[static_cast<std::size_t>(u)])
          reach(x, static_cast<std::size_t>(u), s);
      if (value_[x] < kFar)
        queue_.push({value_[x], v});
    }
    for (std::size_t reached = 0; !queue_.empty();) {
      const auto v = static_cast<std::size_t>(queue_.pop().voxel);
      if (known_[v])
        continue;
      known_[v] = 1;
      if (++reached % 4096 == 0)
        ctx.checkpoint();
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph_.neighbour[v][s]; w >= 0 &&
                                                           !known_[static_cast<std::size_t>(w)] &&
                                                           reach(static_cast<std::size_t>(w), v, s))
          queue_.push({value_[static_cast<std::size_t>(w)], w});
    }
  }

  // Returns whether a step from u lowers the value of v.
  bool reach(std::size_t v, std::size_t u, std::size_t step) {
    const float by = std::max(field_[v], value_[u] + slope_ * kNeighbourDistance[step]);
    if (by >= value_[v])
      return false;
    value_[v] = by;
    return true;
  }

  const VoxelGraph& graph_;
  const std::vector<float>& field_;
  float slope_;
  std::vector<float> value_;
  std::vector<std::uint8_t> known_;
  FrontQueue queue_;
};

} // namespace

std::vector<float> withoutPits(const VoxelGraph& graph, const std::vector<float>& field,
                               float slope, const base::RunContext& ctx) {
  return PitFilling(graph, field, slope).run(ctx);
}

void chamferDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& among,
                     const std::vector<std::uint8_t>& present, std::vector<float>& value,
                     const base::RunContext& ctx) {
  FrontQueue queue;
  for (const std::int32_t v : among) {
    const auto x = static_cast<std::size_t>(v);
    value[x] = graph.onPlatform[x] ? 0.5f : kFar;
    if (graph.onPlatform[x])
      queue.push({0.5f, v});
  }
  std::size_t reached = 0;
  while (!queue.empty()) {
    const Front top = queue.pop();
    const auto v = static_cast<std::size_t>(top.voxel);
    if (top.value > value[v])
      continue;
    if (++reached % 4096 == 0)
      ctx.checkpoint();
    for (std::size_t s = 0; s < kNeighbours; ++s) {
      const std::int32_t w = graph.neighbour[v][s];
      if (w < 0 || !present[static_cast<std::size_t>(w)])
        continue;
      const float by = top.value + kNeighbourDistance[s];
      if (by < value[static_cast<std::size_t>(w)]) {
        value[static_cast<std::size_t>(w)] = by;
        queue.push({by, w});
      }
    }
  }
}

std::vector<float> geodesicDistance(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                                    const base::RunContext& ctx) {
  const std::size_t n = graph.size();
  std::vector<float> distance(n, kFar);
  std::vector<std::uint8_t> known(n, 0);
  FrontQueue queue;
  for (std::size_t v = 0; v < n; ++v)
    if (graph.onPlatform[v]) {
      distance[v] = 0.5f;
      queue.push({0.5f, static_cast<std::int32_t>(v)});
    }
  std::size_t done = 0;
  while (!queue.empty()) {
    const Front top = queue.pop();
    const auto v = static_cast<std::size_t>(top.voxel);
    if (known[v])
      continue;
    known[v] = 1;
    if (++done % 4096 == 0)
      ctx.checkpoint();
    for (std::size_t s = 0; s < kNeighbours; ++s) {
      const std::int32_t w = graph.neighbour[v][s];
      if (w < 0 || known[static_cast<std::size_t>(w)])
        continue;
      const auto x = static_cast<std::size_t>(w);
      if (!rank.empty() && rank[x] < rank[v])
        continue;
      float value = top.value + kNeighbourDistance[s];
      if (s < 6) {
        std::array<float, 3> axisMin{kFar, kFar, kFar};
        for (std::size_t f = 0; f < 6; ++f)
          if (const std::int32_t y = graph.neighbour[x][f];
              y >= 0 && known[static_cast<std::size_t>(y)] &&
              (rank.empty() || rank[static_cast<std::size_t>(y)] <= rank[x]))
            axisMin[f / 2] = std::min(axisMin[f / 2], distance[static_cast<std::size_t>(y)]);
        value = eikonal(axisMin);
      }
      if (value < distance[x]) {
        distance[x] = value;
        queue.push({value, w});
      }
    }
  }
  return distance;
}

} // namespace voluta::curved
