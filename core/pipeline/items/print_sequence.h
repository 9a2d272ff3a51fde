// The order in which parts are printed one after another so that the head clears the finished ones.
#pragma once

#include "pipeline/items/footprint.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::pipeline {

// Two parts: whichever is printed first is in the way of the other one.
struct BlockedPair {
  std::size_t first = 0, second = 0;
  double gapMm = 0.0, neededMm = 0.0;
};

struct PrintSequence {
  std::vector<std::size_t> order; // indices of the parts, each once
  // A pair for which `order` leaves too little room; none: every part clears the earlier ones
  std::optional<BlockedPair> blocked;
};

// Returns the order: of the parts that may come next, the first one as given. If there is no order
// in which all clear, the lowest of the remaining parts comes next. Considers the head above the
// part only, not travels or the arm, which motion planning checks.
PrintSequence printSequence(std::span<const Footprint> parts, const process::HeadShape& head);

} // namespace voluta::pipeline
