#include "milling/drop_cutter.h"

#include <algorithm>
#include <cmath>

namespace voluta::milling {

double dropHeight(const HeightMap& part, const Cutter& cutter, const Eigen::Vector2d& at) {
  const double r = cutter.radiusMm();
  double tip = HeightMap::kNone;
  visitAround(part.grid, at, r, [&](std::size_t cell, double squared) {
    if (part.top[cell] > tip) // the ball is lowest at its middle
      tip = std::max(tip, part.top[cell] + std::sqrt(r * r - squared) - r);
  });
  return tip;
}

} // namespace voluta::milling
