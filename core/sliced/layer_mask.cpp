#include "sliced/layer_mask.h"

#include <algorithm>

namespace voluta::sliced {

using Eigen::Vector2d;

std::size_t LayerMask::cellOf(const Vector2d& point) const {
  const Vector2d at = (point - field.origin) / field.pitch;
  return index(std::clamp(static_cast<int>(at.x()), 0, field.width - 1),
               std::clamp(static_cast<int>(at.y()), 0, field.depth - 1));
}

void LayerMask::mark(const plan::ToolPlan& plan, std::size_t end, std::uint8_t with) {
  eachNear(field, plan, end, 0.0, [&](std::size_t c, double, double) { bits[c] |= with; });
}

LayerMask::Region LayerMask::regionFrom(std::size_t seed) {
  Region region;
  std::vector<std::size_t> open{seed};
  bits[seed] |= kReached;
  while (!open.empty()) {
    const std::size_t c = open.back();
    open.pop_back();
    region.cells.push_back(c);
    region.beads += (bits[c] & kBead) != 0;
    region.infill += (bits[c] & kOfInfill) != 0;
    region.sparse += (bits[c] & kOfSparse) != 0;
    const int i = static_cast<int>(c % static_cast<std::size_t>(field.width));
    const int j = static_cast<int>(c / static_cast<std::size_t>(field.width));
    const auto visit = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= field.width || y >= field.depth) {
        region.isOutside = true;
        return;
      }
      if (const std::size_t n = index(x, y); isOpen(n)) {
        bits[n] |= kReached;
        open.push_back(n);
      }
    };
    visit(i - 1, j);
    visit(i + 1, j);
    visit(i, j - 1);
    visit(i, j + 1);
  }
  return region;
}

int LayerMask::runThrough(std::size_t c, int di, int dj, int limit) const {
  const int i = static_cast<int>(c % static_cast<std::size_t>(field.width));
  const int j = static_cast<int>(c / static_cast<std::size_t>(field.width));
  int run = 1;
  for (const int side : {-1, 1})
    for (int k = 1; run <= limit; ++k, ++run) {
      const int x = i + side * k * di, y = j + side * k * dj;
      if (x < 0 || y < 0 || x >= field.width || y >= field.depth ||
          (bits[index(x, y)] & kOfWall) != 0)
        break;
    }
  return run;
}

bool LayerMask::isThin(const Region& region, int cells) const {
  return std::ranges::all_of(region.cells, [&](std::size_t c) {
    return runThrough(c, 1, 0, cells) <= cells || runThrough(c, 0, 1, cells) <= cells;
  });
}

} // namespace voluta::sliced
