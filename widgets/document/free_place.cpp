#include "document/free_place.h"

#include <algorithm>

namespace voluta::document {

Eigen::Vector2d nextFreePlace(std::span<const Eigen::AlignedBox2d> others,
                              const Eigen::Vector2d& sizeMm, double gapMm) {
  if (others.empty())
    return Eigen::Vector2d::Zero();
  double right = others.front().max().x();
  for (const Eigen::AlignedBox2d& box : others)
    right = std::max(right, box.max().x());
  return {right + gapMm + 0.5 * sizeMm.x(), others.back().center().y()};
}

} // namespace voluta::document
