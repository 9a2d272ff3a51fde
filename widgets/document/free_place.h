// Where a part that is added to the plate goes.
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace voluta::document {

// Returns the centre [mm] at which a part of that size is beside all others: to the right of them,
// with a gap, on the middle line of the last. The origin if there are none.
Eigen::Vector2d nextFreePlace(std::span<const Eigen::AlignedBox2d> others,
                              const Eigen::Vector2d& sizeMm, double gapMm);

} // namespace voluta::document
