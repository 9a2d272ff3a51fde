#include "sliced/layer_mask.h"

#include "process/bead_model.h"

#include <algorithm>
#include <cmath>

namespace voluta::sliced {

using Eigen::Vector2d;

std::size_t LayerMask::cellOf(const Vector2d& point) const {
  const Vector2d at = (point - field.origin) / field.pitch;
  return index(std::clamp(static_cast<int>(at.x()), 0, field.width - 1),
               std::clamp(static_cast<int>(at.y()), 0, field.depth - 1));
}

void LayerMask::mark(const plan::ToolPlan& plan, std::size_t end, std::uint8_t with) {
  const Vector2d a = plan.position[end - 1].head<2>(), b = plan.position[end].head<2>();
  const double width = 0.5 * (plan.widthMm[end - 1] + plan.widthMm[end]);
  const double height = 0.5 * (plan.heightMm[end - 1] + plan.heightMm[end]);
  const double half = 0.5 * process::hatchOf(width, height);
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const auto at = [&](double mm, int axis, int most) {
    return static_cast<int>(
        std::clamp(std::floor((mm - field.origin[axis]) / field.pitch), 0.0, most - 1.0));
  };
  const int left = at(std::min(a.x(), b.x()) - half, 0, field.width);
  const int right = at(std::max(a.x(), b.x()) + half, 0, field.width);
  const int low = at(std::min(a.y(), b.y()) - half, 1, field.depth);
  const int high = at(std::max(a.y(), b.y()) + half, 1, field.depth);
  for (int j = low; j <= high; ++j)
    for (int i = left; i <= right; ++i) {
      const Vector2d centre = field.origin + field.pitch * Vector2d(i + 0.5, j + 0.5);
      const double t =
          length2 > 0.0 ? std::clamp((centre - a).dot(along) / length2, 0.0, 1.0) : 0.0;
      if ((centre - a - t * along).squaredNorm() <= half * half)
        bits[index(i, j)] |= with;
    }
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

int LayerMask::runThrough(std::size_t c, int di, int dj, int most) const {
  const int i = static_cast<int>(c % static_cast<std::size_t>(field.width));
  const int j = static_cast<int>(c / static_cast<std::size_t>(field.width));
  int run = 1;
  for (const int side : {-1, 1})
    for (int k = 1; run <= most; ++k, ++run) {
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
