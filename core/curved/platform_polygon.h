// The platform of growth and collision checks: a convex polygon on the plate.
#pragma once

#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::curved {

// Returns the convex hull, widened by marginMm >= 0, of the cells that are on the plate (z = 0).
// Counter-clockwise, mm. Throws Error{UnusableInput} if no cell is on the plate.
std::vector<Eigen::Vector2d> platformFit(const voxel::SolidVoxels& voxels, double marginMm);

// Returns a disc about `centre` as a regular polygon with 64 corners on the circle; diameter > 0,
// mm.
std::vector<Eigen::Vector2d> platformDisc(double diameterMm,
                                          const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

// Returns a rectangle about `centre`, width along x, depth along y, both > 0, mm.
std::vector<Eigen::Vector2d> platformRect(double widthMm, double depthMm,
                                          const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

} // namespace voluta::curved
