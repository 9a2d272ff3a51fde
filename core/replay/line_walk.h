// Walks straight lines through a box of cells, four at a time.
#pragma once

#include "base/lanes.h"

#include <Eigen/Core>
#include <array>

namespace voluta::replay {

using base::Floats;
using base::Ints;
using base::kLanes;

// Four lines by axis, in cells from the box's corner.
struct Lines {
  std::array<Floats, 3> from, to;
};

// Calls f(cells of the box, share of each line in its cell), from cell to cell (Amanatides & Woo
// 1987). A line that ends earlier stays in its last cell with share 0. Ends outside the box by
// rounding are moved inside, far enough that rounding cannot lead out again.
template <typename F> void alongLines(const Lines& lines, const Eigen::Vector3i& size, F&& f) {
  constexpr float kInside = 1e-3f;
  const std::array<int, 3> strides = {1, size.x(), size.x() * size.y()};
  const Floats none = {};
  Ints cell = {};
  std::array<Ints, 3> stride;
  // In shares of the line: start of the next cell, and length per cell.
  std::array<Floats, 3> next, across;
  for (std::size_t k = 0; k < 3; ++k) {
    const Floats first = none + kInside,
                 last = none + (static_cast<float>(size[static_cast<int>(k)]) - kInside);
    const Floats from = base::min(base::max(lines.from[k], first), last),
                 to = base::min(base::max(lines.to[k], first), last), step = to - from;
    const Ints at = base::intsOf(from), back = step < 0.0f;
    cell += strides[k] * at;
    stride[k] = back ? Ints{} - strides[k] : Ints{} + strides[k];
    across[k] = step == 0.0f ? none + 2.0f : 1.0f / base::absOf(step);
    const Floats in = from - base::floatsOf(at);
    next[k] = step == 0.0f ? none + 2.0f : (back ? in : 1.0f - in) * across[k];
  }
  Floats done = none;
  for (;;) {
    const Floats minimum = base::min(base::min(next[0], next[1]), next[2]);
    const Ints continues = minimum < 1.0f;
    const Floats end = continues ? minimum : none + 1.0f;
    f(cell, end - done);
    bool any = false;
    for (int l = 0; l < kLanes; ++l)
      any |= continues[l] != 0;
    if (!any)
      return;
    done = end;
    const Ints is0 = next[0] == minimum, is1 = ~is0 & (next[1] == minimum), is2 = ~(is0 | is1);
    next[0] += is0 ? across[0] : none;
    next[1] += is1 ? across[1] : none;
    next[2] += is2 ? across[2] : none;
    cell += continues & ((is0 & stride[0]) | (is1 & stride[1]) | (is2 & stride[2]));
  }
}

} // namespace voluta::replay
