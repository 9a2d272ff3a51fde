// Where a part that is added to the plate goes.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace voluta::document {

// Returns the centre [mm] at which a part of that size is beside all others with a gap: to the
// right of them, on the middle line of the last, if that is on the first of `plates`; otherwise
// right of, behind, left of or in front of one of them, the first such place on the first plate
// that has one; without any, to the right of all. The origin if there are no others. `plates`:
// convex, counter-clockwise, in the order in which they are tried; empty: anywhere.
Eigen::Vector2d nextFreePlace(std::span<const Eigen::AlignedBox2d> others,
                              const Eigen::Vector2d& sizeMm, double gapMm,
                              const std::vector<std::vector<Eigen::Vector2d>>& plates = {});

} // namespace voluta::document
