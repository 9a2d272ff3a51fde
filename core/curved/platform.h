// What material starts on: a convex polygon on the plate, in growth and in collision alike.
#pragma once

#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::curved {

// Convex hull, widened by marginMm >= 0, of the cells that stand on the plate (z = 0).
// Counter-clockwise, mm. Throws Error{UnusableInput} when no cell stands on the plate.
std::vector<Eigen::Vector2d> platformFit(const voxel::SolidVoxels& voxels, double marginMm);

// Disc about `centre` as a regular polygon of 64 corners on the circle; diameter > 0, mm.
std::vector<Eigen::Vector2d> platformDisc(double diameterMm,
                                          const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

// Rectangle about `centre`, width along x, depth along y, both > 0, mm.
std::vector<Eigen::Vector2d> platformRect(double widthMm, double depthMm,
                                          const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

} // namespace voluta::curved
