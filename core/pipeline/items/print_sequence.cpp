#include "pipeline/items/print_sequence.h"

#include <algorithm>
#include <numeric>

namespace voluta::pipeline {

namespace {
// Chooses the next part again and again.
class Sequencer {
public:
  Sequencer(std::span<const Footprint> parts, const process::HeadShape& head)
      : parts_(parts), head_(head), left_(parts.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  PrintSequence run() {
    PrintSequence out;
    while (!left_.empty()) {
      auto next = std::ranges::find_if(left_, [this](std::size_t i) { return !hinders(i); });
      if (next == left_.end()) {
        next = std::ranges::min_element(left_, {},
                                        [this](std::size_t i) { return parts_[i].heightMm; });
        if (!out.blocked)
          out.blocked = hinders(*next);
      }
      out.order.push_back(*next);
      left_.erase(next);
    }
    return out;
  }

private:
  // Returns a pair with a part that could not be printed any more beside part i.
  std::optional<BlockedPair> hinders(std::size_t i) const {
    for (const std::size_t later : left_) {
      if (later == i)
        continue;
      const double gap = gapBetween(parts_[later], parts_[i]);
      const double needed = headNeedsMm(head_, parts_[later], parts_[i]);
      if (gap < needed)
        return BlockedPair{i, later, gap, needed};
    }
    return std::nullopt;
  }

  std::span<const Footprint> parts_;
  const process::HeadShape& head_;
  std::vector<std::size_t> left_;
};
} // namespace

PrintSequence printSequence(std::span<const Footprint> parts, const process::HeadShape& head) {
  return Sequencer(parts, head).run();
}

} // namespace voluta::pipeline
