#include "geometry/box_grid.h"

#include <cmath>

namespace voluta::geometry {

namespace {
constexpr double kMaxCells = 1 << 22;
}

template <typename Visit>
void BoxGrid::forCells(const Eigen::AlignedBox3d& box, const Visit& visit) const {
  const Eigen::Array3i low = cellOf(box.min()), high = cellOf(box.max());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        visit(indexOf({x, y, z}));
}

BoxGrid::BoxGrid(std::span<const Eigen::AlignedBox3d> boxes, double cellMm) {
  for (const Eigen::AlignedBox3d& box : boxes)
    around_.extend(box);
  if (boxes.empty())
    return;
  const Eigen::Array3d sides = around_.sizes().array().max(cellMm);
  cellMm_ = std::max(cellMm, std::cbrt(sides.prod() / kMaxCells));
  size_ = (sides / cellMm_).floor().cast<int>() + 1;
  first_.assign(static_cast<std::size_t>(size_.cast<std::int64_t>().prod()) + 1, 0);
  for (const Eigen::AlignedBox3d& box : boxes)
    forCells(box, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell)
    first_[cell] += first_[cell - 1];
  items_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    forCells(boxes[b],
             [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::uint32_t>(b); });
}

} // namespace voluta::geometry
