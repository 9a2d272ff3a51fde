// The sources' growth schemes by brute force, to compare with.
#pragma once

#include "curved/convex_hull.h"
#include "curved/forward_growth.h"
#include "curved/layer_order.h"
#include "curved/peeling_field.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace voluta::test {

inline bool insideHull(const std::vector<curved::HullFacet>& hull, const curved::LatticePoint& p,
                       curved::Boundary boundary) {
  return !hull.empty() && std::all_of(hull.begin(), hull.end(), [&](const curved::HullFacet& f) {
    const double above = f.normal.dot(p) - f.offset;
    return above < 0.0 || (boundary == curved::Boundary::Inside && above == 0.0);
  });
}

// The algorithms as forward_growth.h states them, with a hull from scratch for every voxel tried
// and every query of an unprinted voxel.
class PlainGrowth {
public:
  PlainGrowth(const curved::VoxelGraph& graph, curved::ForwardScheme scheme,
              const curved::ForwardOptions& options)
      : graph_(graph), scheme_(scheme), options_(options), rank(graph.size(), 0),
        state_(graph.size(), State::Free) {
    const std::vector<std::int32_t> peeled = curved::peelingField(graph, base::RunContext());
    const std::int32_t last = *std::max_element(peeled.begin(), peeled.end());
    for (const std::int32_t f : peeled)
      height_.push_back(scheme == curved::ForwardScheme::Guided ? last + 1 - f : 0);
    std::vector<std::int32_t> layer;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (graph.onPlatform[v])
        layer.push_back(static_cast<std::int32_t>(v));
    corners_ = graph.platform;
    for (std::int32_t r = 1; !layer.empty(); ++r) {
      for (const std::int32_t v : layer) {
        rank[at(v)] = r;
        state_[at(v)] = State::Printed;
      }
      corners_ = cornersWith(layer);
      lose(insideOf(corners_));
      for (const std::int32_t v : layer)
        for (const std::int32_t w : graph.neighbour[at(v)])
          if (w >= 0 && state_[at(w)] == State::Free) {
            state_[at(w)] = State::Waiting;
            waiting_.push_back(w);
          }
      layer = next();
    }
  }

private:
  enum class State { Free, Waiting, Tried, Printed, Lost };
  static std::size_t at(std::int32_t v) { return static_cast<std::size_t>(v); }

  std::vector<curved::LatticePoint> cornersWith(const std::vector<std::int32_t>& more) const {
    std::vector<curved::LatticePoint> points = corners_;
    for (const std::int32_t v : more)
      points.push_back(graph_.lattice(at(v)));
    std::vector<curved::LatticePoint> corners;
    std::vector<std::uint8_t> kept(points.size(), 0);
    for (const curved::HullFacet& f : curved::convexHull(points))
      for (const int c : f.corner)
        if (!std::exchange(kept[at(c)], 1))
          corners.push_back(points[at(c)]);
    return corners;
  }

  // Unlaid voxels inside the hull that do not wait for their turn in the layer.
  std::vector<std::int32_t> insideOf(const std::vector<curved::LatticePoint>& corners) const {
    const std::vector<curved::HullFacet> hull = curved::convexHull(corners);
    std::vector<std::int32_t> out;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if ((state_[v] == State::Free || state_[v] == State::Waiting) &&
          insideHull(hull, graph_.lattice(v), options_.boundary))
        out.push_back(static_cast<std::int32_t>(v));
    return out;
  }

  void lose(const std::vector<std::int32_t>& voxels) {
    for (const std::int32_t v : voxels)
      state_[at(v)] = State::Lost;
  }

  std::vector<std::int32_t> next() {
    for (;;) {
      waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                    [&](std::int32_t v) { return state_[at(v)] == State::Lost; }),
                     waiting_.end());
      std::vector<std::int32_t> layer;
      const auto propose = [&] {
        for (const std::int32_t v : waiting_)
          if (height_[at(v)] <= threshold_)
            layer.push_back(v);
      };
      propose();
      while (layer.empty() && !waiting_.empty()) {
        threshold_ += options_.fieldStep;
        propose();
      }
      if (layer.empty() || scheme_ == curved::ForwardScheme::Greedy) {
        waiting_.clear();
        return layer;
      }
      for (const std::int32_t v : layer)
        state_[at(v)] = State::Tried;
      const std::vector<std::int32_t> shadowed = insideOf(cornersWith(layer));
      const std::vector<std::int32_t> queue =
          scheme_ != curved::ForwardScheme::Incremental    ? curved::halvingOrder(graph_, layer)
          : options_.queue == curved::QueueOrder::Flooding ? curved::floodingOrder(graph_, layer)
                                                           : layer;
      std::size_t limit = options_.ispThreshold > 0
                              ? static_cast<std::size_t>(options_.ispThreshold)
                              : shadowed.size();
      std::vector<std::int32_t> taken;
      if (shadowed.empty() || shadowed.size() < limit)
        taken = layer;
      else
        taken = reduced(queue, limit);
      const bool more = layer.size() < waiting_.size();
      if (taken.empty() && more) {
        for (const std::int32_t v : layer)
          state_[at(v)] = State::Waiting;
        std::stable_partition(waiting_.begin(), waiting_.end(),
                              [&](std::int32_t v) { return height_[at(v)] <= threshold_; });
        const std::int32_t before = threshold_;
        while (std::none_of(waiting_.begin(), waiting_.end(), [&](std::int32_t v) {
          return height_[at(v)] > before && height_[at(v)] <= threshold_;
        }))
          threshold_ += options_.fieldStep;
        continue;
      }
      if (taken.empty() && options_.sacrifice == curved::Sacrifice::Fewest) {
        limit = shadowed.size();
        for (const std::int32_t v : layer)
          limit = std::min(limit, insideOf(cornersWith({v})).size());
        taken = reduced(queue, limit + 1);
      }
      if (taken.empty())
        taken = layer;
      std::vector<std::int32_t> rest;
      for (const std::int32_t v : queue)
        if (std::find(taken.begin(), taken.end(), v) == taken.end()) {
          rest.push_back(v);
          state_[at(v)] = State::Waiting;
        }
      for (const std::int32_t v : waiting_)
        if (std::find(layer.begin(), layer.end(), v) == layer.end())
          rest.push_back(v);
      waiting_ = rest;
      return taken;
    }
  }

  std::vector<std::int32_t> reduced(const std::vector<std::int32_t>& queue, std::size_t limit) {
    std::vector<std::int32_t> taken;
    for (const std::int32_t v : queue) {
      taken.push_back(v);
      if (insideOf(cornersWith(taken)).size() >= limit) {
        taken.pop_back();
        state_[at(v)] = State::Waiting;
      }
    }
    for (const std::int32_t v : queue)
      state_[at(v)] = State::Tried;
    return taken;
  }

  const curved::VoxelGraph& graph_;
  curved::ForwardScheme scheme_;
  curved::ForwardOptions options_;

public:
  std::vector<std::int32_t> rank;

private:
  std::vector<State> state_;
  std::vector<std::int32_t> height_, waiting_;
  std::vector<curved::LatticePoint> corners_;
  std::int32_t threshold_ = 1;
};

} // namespace voluta::test
