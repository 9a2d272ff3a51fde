// Where a drop falls.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace voluta::geometry {

// Returns whether a drop that leaves `from` along `down` meets the box, faces included. False for
// an empty box. `down` need not be a unit vector.
inline bool dropMeets(const Eigen::Vector3d& from, const Eigen::Vector3d& down,
                      const Eigen::AlignedBox3d& box) {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (down[k] == 0.0) {
      if (from[k] < box.min()[k] || from[k] > box.max()[k])
        return false;
      continue;
    }
    const double a = (box.min()[k] - from[k]) / down[k], b = (box.max()[k] - from[k]) / down[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return !box.isEmpty() && enter <= leave;
}

// Returns the box, wider by that margin on all sides; an empty one stays empty.
inline Eigen::AlignedBox3d widened(Eigen::AlignedBox3d box, double byMm) {
  if (!box.isEmpty()) {
    box.min().array() -= byMm;
    box.max().array() += byMm;
  }
  return box;
}

} // namespace voluta::geometry
