#include "milling/stock.h"

#include <algorithm>
#include <cmath>

namespace voluta::milling {

using Eigen::Vector2d;
using Eigen::Vector3d;

Stock::Stock(const Eigen::AlignedBox3d& block, double pitchMm)
    : grid_(gridOver(block.min().head<2>(), block.max().head<2>(), pitchMm)),
      low_(grid_.size(), block.min().z()), high_(grid_.size(), block.max().z()) {}

double Stock::volumeMm3() const {
  double height = 0.0;
  for (std::size_t c = 0; c < grid_.size(); ++c)
    height += std::max(0.0, high_[c] - low_[c]);
  return height * grid_.pitchMm * grid_.pitchMm;
}

double Stock::cut(const Cutter& cutter, const Vector3d& from, const Vector3d& to) {
  const double r = cutter.radiusMm();
  const int steps = std::max(
      1, static_cast<int>(std::ceil((to - from).head<2>().norm() / (0.5 * grid_.pitchMm))));
  double removed = 0.0;
  for (int s = 0; s <= steps; ++s) {
    const Vector3d tip = from + (to - from) * s / steps;
    visitAround(grid_, tip.head<2>(), r, [&](std::size_t cell, double squared) {
      const double bottom = tip.z() + r - std::sqrt(r * r - squared);
      if (bottom >= high_[cell])
        return;
      removed += std::max(0.0, high_[cell] - std::max(bottom, low_[cell]));
      high_[cell] = bottom;
    });
  }
  return removed * grid_.pitchMm * grid_.pitchMm;
}

Stock Stock::turned() const {
  Stock out = *this;
  out.grid_.low.y() = -(grid_.low.y() + grid_.pitchMm * grid_.countY);
  for (int j = 0; j < grid_.countY; ++j)
    for (int i = 0; i < grid_.countX; ++i) {
      const std::size_t from = grid_.index(i, j), to = grid_.index(i, grid_.countY - 1 - j);
      out.low_[to] = -high_[from];
      out.high_[to] = -low_[from];
    }
  return out;
}

} // namespace voluta::milling
