// Grid for finding the small boxes near a place.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace voluta::geometry {

class BoxGrid {
public:
  BoxGrid() = default;
  // `cellMm` > 0: about the width of the boxes; cells are wider if there would be too many.
  BoxGrid(std::span<const Eigen::AlignedBox3d> boxes, double cellMm);

  // Calls visit(index) for every box that may intersect `near`, for some more than once, until it
  // returns true. Returns whether it did.
  template <typename Visit> bool any(const Eigen::AlignedBox3d& near, const Visit& visit) const {
    if (items_.empty() || !near.intersects(around_))
      return false;
    const Eigen::Array3i low = cellOf(near.min()), high = cellOf(near.max());
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const std::size_t cell = indexOf({x, y, z});
          for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k)
            if (visit(items_[k]))
              return true;
        }
    return false;
  }

private:
  Eigen::Array3i cellOf(const Eigen::Vector3d& p) const {
    return ((p - around_.min()).array() / cellMm_).cast<int>().max(0).min(size_ - 1);
  }
  std::size_t indexOf(const Eigen::Array3i& c) const {
    return static_cast<std::size_t>(c.x()) +
           static_cast<std::size_t>(size_.x()) *
               (static_cast<std::size_t>(c.y()) +
                static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(c.z()));
  }
  template <typename Visit> void forCells(const Eigen::AlignedBox3d& box, const Visit& visit) const;

  Eigen::AlignedBox3d around_;
  double cellMm_ = 1.0;
  Eigen::Array3i size_ = Eigen::Array3i::Zero();
  std::vector<std::uint32_t> first_, items_; // the boxes of each cell; first_ has one entry more
};

} // namespace voluta::geometry
