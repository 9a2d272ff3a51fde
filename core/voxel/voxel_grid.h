// A regular grid of cubic cells; values are stored in separate flat arrays.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace voluta::voxel {

struct VoxelGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // Lowest corner of cell (0,0,0) [mm]
  double pitch = 1.0;                               // Width of a cell [mm]
  Eigen::Vector3i size = Eigen::Vector3i::Zero();   // Cells along x, y, z

  std::size_t cellCount() const {
    return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
           static_cast<std::size_t>(size.z());
  }
  // x varies fastest.
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k));
  }
  Eigen::Vector3i cell(std::size_t index) const {
    const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
    return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
            static_cast<int>(index / (nx * ny))};
  }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size.x() && j < size.y() && k < size.z();
  }
  // Returns the centre of a cell [mm].
  Eigen::Vector3d centre(int i, int j, int k) const {
    return {origin.x() + pitch * (i + 0.5), origin.y() + pitch * (j + 0.5),
            origin.z() + pitch * (k + 0.5)};
  }
  // Returns the cell that contains a point; may be outside the grid.
  Eigen::Vector3i cellOf(const Eigen::Vector3d& point) const {
    const auto along = [this](double to, double from) {
      return static_cast<int>(std::floor((to - from) / pitch));
    };
    return {along(point.x(), origin.x()), along(point.y(), origin.y()),
            along(point.z(), origin.z())};
  }
};

} // namespace voluta::voxel
