#include "curved/forward_growth.h"

#include "base/error.h"
#include "curved/layer_order.h"
#include "curved/live_blocks.h"
#include "curved/peeling_field.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voluta::curved {

namespace {

class Grower {
public:
  Grower(const VoxelGraph& graph, ForwardScheme scheme, const ForwardOptions& options,
         const base::RunContext& ctx)
      : graph_(graph), scheme_(scheme), options_(options), ctx_(ctx), points_(allPoints(graph)),
        front_(points_, options.boundary), trial_(points_, options.boundary), blocks_(graph),
        found_(graph.size(), 0), inLayer_(graph.size(), 0) {
    out_.rank.assign(graph.size(), 0);
  }

  ForwardGrowth run() {
    if (guided())
      readField();
    const base::RunContext growing = ctx_.sub(guided() ? 0.1 : 0.0, 1.0);
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (graph_.onPlatform[v]) {
        found_[v] = 1;
        layer_.push_back(static_cast<std::int32_t>(v));
      }
    if (layer_.empty())
      return std::move(out_);
    startFront();
    std::size_t printed = 0;
    while (!layer_.empty()) {
      lay();
      printed += layer_.size();
      growing.report(static_cast<double>(printed) / static_cast<double>(graph_.size()),
                     "growth"_text);
      advance();
    }
    return std::move(out_);
  }

private:
  static std::vector<LatticePoint> allPoints(const VoxelGraph& graph) {
    std::vector<LatticePoint> points(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v)
      points[v] = graph.lattice(v);
    points.insert(points.end(), graph.platform.begin(), graph.platform.end());
    return points;
  }

  bool guided() const { return scheme_ == ForwardScheme::Guided; }

  void readField() {
    out_.peeling = peelingField(graph_, ctx_.sub(0.0, 0.1));
    const std::int32_t last =
        out_.peeling.empty() ? 0 : *std::max_element(out_.peeling.begin(), out_.peeling.end());
    height_.resize(graph_.size());
    for (std::size_t v = 0; v < graph_.size(); ++v)
      height_[v] = 1 + last - out_.peeling[v];
    threshold_ = options_.fieldStep;
  }

  void startFront() {
    std::vector<std::int32_t> corners = layer_;
    for (std::size_t c = 0; c < graph_.platform.size(); ++c)
      corners.push_back(static_cast<std::int32_t>(graph_.size() + c));
    front_.build(corners);
    base::require(!front_.empty(), "forwardGrowth: a platform with an area");
    blocks_.remove(layer_);
    blocks_.inside(front_, shadowed_);
    blocks_.remove(shadowed_);
  }

  // Records the layer; the front already includes it.
  void lay() {
    ++out_.ranks;
    for (const std::int32_t v : layer_)
      out_.rank[static_cast<std::size_t>(v)] = out_.ranks;
    blocks_.remove(layer_);
    for (const std::int32_t v : layer_)
      for (const std::int32_t w : graph_.neighbour[static_cast<std::size_t>(v)])
        if (w >= 0 && !found_[static_cast<std::size_t>(w)]) {
          found_[static_cast<std::size_t>(w)] = 1;
          waiting_.push_back(w);
        }
  }

  // Finds the next layer and extends the front by it; the layer stays empty if growth ends.
  void advance() {
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                  [&](std::int32_t v) { return front_.inside(v); }),
                   waiting_.end());
    propose();
    while (!layer_.empty() && !choose()) {
      // No voxel of the layer is safe now; some may be after voxels that the field has held back.
      waiting_.insert(waiting_.begin(), layer_.begin(), layer_.end());
      raiseThreshold();
      propose();
    }
  }

  // Moves the voxels that the field releases from waiting_ to layer_.
  void propose() {
    const auto free = [&] {
      return std::stable_partition(waiting_.begin(), waiting_.end(), [&](std::int32_t v) {
        return !guided() || height_[static_cast<std::size_t>(v)] <= threshold_;
      });
    };
    auto held = free();
    if (held == waiting_.begin() && !waiting_.empty()) {
      raiseThreshold();
      held = free();
    }
    layer_.assign(waiting_.begin(), held);
    waiting_.erase(waiting_.begin(), held);
  }

  // Raises the threshold to the next step that releases a voxel. Precondition: the field holds back
  // at least one.
  void raiseThreshold() {
    std::int32_t next = std::numeric_limits<std::int32_t>::max();
    for (const std::int32_t v : waiting_)
      if (const std::int32_t h = height_[static_cast<std::size_t>(v)]; h > threshold_)
        next = std::min(next, h);
    const std::int32_t step = options_.fieldStep;
    threshold_ = (next - 1) / step * step + step;
  }

  // Reduces the layer to the voxels that may be printed and extends the front by them. Returns
  // false and changes nothing if no voxel is safe but more may still be proposed.
  bool choose() {
    trial_ = front_;
    for (const std::int32_t v : layer_)
      trial_.add(v, swallowed_);
    if (scheme_ == ForwardScheme::Greedy) {
      std::swap(front_, trial_);
      return true;
    }
    findShadowed();
    if (shadowed_.empty() || static_cast<std::int64_t>(shadowed_.size()) < options_.ispThreshold) {
      layWhole();
      return true;
    }
    const std::vector<std::int32_t> tried = order();
    if (reduce(tried, options_.ispThreshold > 0 ? static_cast<std::size_t>(options_.ispThreshold)
                                                : shadowed_.size())) {
      ++out_.reduced;
      return true;
    }
    if (!waiting_.empty())
      return false;
    ++out_.sacrificed;
    if (options_.sacrifice == Sacrifice::Fewest)
      reduce(tried, minLoss() + 1);
    else
      layWhole();
    return true;
  }

  // Finds the voxels that printing the whole layer would shadow.
  void findShadowed() {
    for (const std::int32_t v : layer_)
      inLayer_[static_cast<std::size_t>(v)] = 1;
    blocks_.inside(trial_, shadowed_);
    shadowed_.erase(
        std::remove_if(shadowed_.begin(), shadowed_.end(),
                       [&](std::int32_t v) { return inLayer_[static_cast<std::size_t>(v)] != 0; }),
        shadowed_.end());
    for (const std::int32_t v : layer_)
      inLayer_[static_cast<std::size_t>(v)] = 0;
  }

  void layWhole() {
    std::swap(front_, trial_);
    blocks_.remove(shadowed_);
  }

  // Keeps the voxels of the layer that together shadow fewer than `limit` further voxels. Returns
  // false if none would be left.
  bool reduce(const std::vector<std::int32_t>& tried, std::size_t limit) {
    std::vector<std::int32_t> safe, unsafe;
    swallowed_.clear();
    guardShadowed();
    for (const std::int32_t v : tried) {
      ctx_.checkpoint();
      const std::size_t allowance = limit - swallowed_.size();
      if (front_.wouldSwallow(v, allowance) < allowance) {
        front_.add(v, swallowed_);
        safe.push_back(v);
      } else {
        // No safe voxel can swallow it, as that hull would contain everything v itself swallows
        unsafe.push_back(v);
      }
    }
    front_.clearGuards();
    if (safe.empty())
      return false;
    blocks_.remove(swallowed_);
    waiting_.insert(waiting_.begin(), unsafe.begin(), unsafe.end());
    layer_ = std::move(safe);
    return true;
  }

  void guardShadowed() {
    front_.clearGuards();
    for (const std::int32_t v : shadowed_)
      front_.guard(v);
  }

  // Returns the number of voxels shadowed by the voxel of the layer that shadows fewest.
  std::size_t minLoss() {
    std::size_t minimum = shadowed_.size();
    guardShadowed();
    for (const std::int32_t v : layer_)
      minimum = std::min(minimum, front_.wouldSwallow(v, minimum));
    return minimum;
  }

  std::vector<std::int32_t> order() const {
    if (scheme_ != ForwardScheme::Incremental)
      return halvingOrder(graph_, layer_);
    return options_.queue == QueueOrder::Flooding ? floodingOrder(graph_, layer_) : layer_;
  }

  const VoxelGraph& graph_;
  ForwardScheme scheme_;
  ForwardOptions options_;
  const base::RunContext& ctx_;
  std::vector<LatticePoint> points_; // Centres of voxels, then the platform's corners
  IncrementalFront front_, trial_;
  LiveBlocks blocks_;
  std::vector<std::uint8_t> found_; // Has been in waiting_
  std::vector<std::uint8_t> inLayer_;
  std::vector<std::int32_t> waiting_, layer_, shadowed_, swallowed_, height_;
  std::int32_t threshold_ = 0;
  ForwardGrowth out_;
};

} // namespace

ForwardGrowth forwardGrowth(const VoxelGraph& graph, ForwardScheme scheme,
                            const ForwardOptions& options, const base::RunContext& ctx) {
  base::require(options.ispThreshold >= 0 && options.fieldStep >= 1,
                "forwardGrowth: ispThreshold >= 0, fieldStep >= 1");
  return Grower(graph, scheme, options, ctx).run();
}

} // namespace voluta::curved
