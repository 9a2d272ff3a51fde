#include "planar/point_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::planar {

PointBlocks::PointBlocks(std::vector<Eigen::Vector3d> points) : points_(std::move(points)) {
  constexpr double kBlockMm = 16.0;
  const auto blockOf = [](const Eigen::Vector3d& p) {
    return std::array{std::floor(p.x() / kBlockMm), std::floor(p.y() / kBlockMm),
                      std::floor(p.z() / kBlockMm)};
  };
  std::stable_sort(points_.begin(), points_.end(),
                   [&](const auto& a, const auto& b) { return blockOf(a) < blockOf(b); });
  for (auto begin = points_.begin(); begin != points_.end();) {
    Eigen::AlignedBox3d box;
    auto end = begin;
    for (; end != points_.end() && blockOf(*end) == blockOf(*begin); ++end)
      box.extend(*end);
    blocks_.emplace_back(std::span<const Eigen::Vector3d>(begin, end), box);
    box_.extend(box);
    begin = end;
  }
}

} // namespace voluta::planar
