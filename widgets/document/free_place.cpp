#include "document/free_place.h"

#include <algorithm>

namespace voluta::document {

namespace {
constexpr double kGapMm = 10.0;
}

Eigen::Vector2d nextFreePlace(std::span<const Eigen::AlignedBox2d> others,
                              const Eigen::Vector2d& sizeMm) {
  if (others.empty())
    return Eigen::Vector2d::Zero();
  double right = others.front().max().x();
  for (const Eigen::AlignedBox2d& box : others)
    right = std::max(right, box.max().x());
  return {right + kGapMm + 0.5 * sizeMm.x(), others.back().center().y()};
}

} // namespace voluta::document
