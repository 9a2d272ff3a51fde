// The plate under a piece, and how well the piece stands on it.
#pragma once

#include "planar/decomposition.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// The plate's polygon where `piece` stands on it: options.platform.polygon, or the one made for
// the piece; of a piece that does not stand on the plate that of the options.
std::vector<Eigen::Vector2d> plateUnder(const Piece& piece, const PlanarOptions& options);

// Points all over what carries the plate, `spacingMm` apart.
std::vector<Eigen::Vector3d> carrierSamples(const PlanarPlatform& platform, double spacingMm);

// Points of a piece that stands on the plate and points of that plate and what carries it,
// `spacingMm` apart; of another piece its own.
std::vector<Eigen::Vector3d> withPlate(std::vector<Eigen::Vector3d> points, const Piece& piece,
                                       const PlanarOptions& options, double spacingMm);

// What a part stands on.
struct Footing {
  double contactMm2 = 0.0;
  double hullMm2 = 0.0; // of the hull of it
};
Footing footingOf(const Piece& piece, const RiskRule& rule);
// Of that which would be left below the plane.
Footing footingBelow(const Piece& piece, const std::vector<std::uint8_t>& stands,
                     const Plane& plane);

} // namespace voluta::planar
