// The plate below a piece, and the piece's contact with it.
#pragma once

#include "planar/planar_decomposition.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// Returns the plate's polygon for a piece on the plate: options.platform.polygon, or the one made
// for the piece. For other pieces returns the polygon of the options.
std::vector<Eigen::Vector2d> plateUnder(const Piece& piece, const PlanarOptions& options);

// Returns points on all surfaces of the bodies that carry the plate, `spacingMm` apart.
std::vector<Eigen::Vector3d> carrierSamples(const PlanarPlatform& platform, double spacingMm);

// Adds points of the plate and of the bodies that carry it, `spacingMm` apart, to the points of a
// piece on the plate. Points of other pieces are returned unchanged.
std::vector<Eigen::Vector3d> withPlate(std::vector<Eigen::Vector3d> points, const Piece& piece,
                                       const PlanarOptions& options, double spacingMm);

// Returns options that allow a larger loss of contact with the plate, if not all of it must stay.
PlanarOptions withLessContact(const PlanarOptions& options);

// The contact area of a part and its convex hull.
struct Footing {
  double contactMm2 = 0.0;
  double hullMm2 = 0.0; // area of the contact area's convex hull
};
Footing footingOf(const Piece& piece, const RiskRule& rule);
// Returns the footing that would remain below the plane.
Footing footingBelow(const Piece& piece, const std::vector<std::uint8_t>& stands,
                     const Plane& plane);

} // namespace voluta::planar
